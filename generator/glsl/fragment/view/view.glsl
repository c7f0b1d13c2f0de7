// SPDX-License-Identifier: MIT
// The surface and the eye, for all lights.
//! functions
struct View {
  vec3 normal; // N: unit, world space
  vec3 toCamera; // V: unit, world space
  float nDotV; // N.V, kept off 0, where visibility would divide by it
};

// normal: unit. toCamera: any length.
View viewOf(vec3 normal, vec3 toCamera) {
  vec3 v = toCamera * inverseSquareRoot(dot(toCamera, toCamera));
  return View(normal, v, max(dot(normal, v), 1.0e-4));
}
//! main
  View view = viewOf(normal, vToCamera);
