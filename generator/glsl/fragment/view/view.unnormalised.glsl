// SPDX-License-Identifier: MIT
// The surface and the eye, for one or two lights: scaling products is cheaper than scaling vectors.
//! functions
struct View {
  vec3 normal; // N: any length, world space
  vec3 toCamera; // V: any length, world space
  float inverseN; // 1 / |N|
  float inverseV; // 1 / |V|
  float nDotV; // N.V of unit vectors, kept off 0, where visibility would divide by it
};

View viewOf(vec3 normal, vec3 toCamera) {
  float inverseN = inverseSquareRoot(dot(normal, normal));
  float inverseV = inverseSquareRoot(dot(toCamera, toCamera));
  float nDotV = max(dot(normal, toCamera) * (inverseV * inverseN), 1.0e-4);
  return View(normal, toCamera, inverseN, inverseV, nDotV);
}
//! main
  View view = viewOf(normal, vToCamera);
