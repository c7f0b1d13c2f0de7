// SPDX-License-Identifier: MIT
// The surface and the eye, for one or two lights: scaling products is cheaper than scaling vectors. The length that V
// has after scaling is used as it is: an inexact root (roots on VideoCore IV) then errs alike in N.H' and |H'|^2,
// whose difference is the width of a highlight.
//! functions
struct View {
  vec3 normal; // N: any length, world space
  vec3 toCamera; // V: any length, world space
  float inverseN; // 1 / |N|
  float inverseV; // 1 / |V|
  float n2; // |N|^2
  float v2; // 1 + |V|^2 of the scaled V, kept off 2
  float facing; // N.V of the scaled V
  float nDotV; // N.V of unit vectors, kept off 0, where visibility would divide by it
};

View viewOf(vec3 normal, vec3 toCamera) {
  float n2 = dot(normal, normal);
  float v2 = dot(toCamera, toCamera);
  float inverseN = inverseSquareRoot(n2);
  float inverseV = inverseSquareRoot(v2);
  v2 = v2 * (inverseV * inverseV) + 1.000002;
  float facing = max(dot(normal, toCamera) * inverseV, 5.0e-5);
  return View(normal, toCamera, inverseN, inverseV, n2, v2, facing, facing * inverseN);
}
//! main
  View view = viewOf(normal, vToCamera);
