// SPDX-License-Identifier: MIT
// The surface and the eye, with the direction to the eye as the vertex shader normalised it.
//! functions
struct View {
  vec3 normal; // N: unit, world space
  float nDotV; // N.V, kept off 0, where visibility would divide by it
  float v2; // 1 + |V|^2, kept off 2
};
//! main
  float nDotV = max(dot(normal, vToCamera), 1.0e-4);
  View view = View(normal, nDotV, dot(vToCamera, vToCamera) + 1.000002);
