// SPDX-License-Identifier: MIT
// The surface and the eye, for all lights.
//! functions
struct View {
  vec3 normal; // N: unit, world space
  vec3 toCamera; // V: unit, world space
  float nDotV; // N.V, kept off 0, where V(isibility) would divide by it
};
//! main
  vec3 toCamera = vToCamera * inverseSquareRoot(dot(vToCamera, vToCamera));
  View view = View(normal, toCamera, max(dot(normal, toCamera), 1.0e-4));
