// SPDX-License-Identifier: MIT
// The surface and the eye in tangent space, from vectors that the vertex shader brought there.
//! functions
struct View {
  vec3 normal; // N: any length, tangent space
  float inverseN; // 1 / |N|
  float nDotV; // N.V of unit vectors, kept off 0, where visibility would divide by it
};
//! main
  float inverseN = inverseSquareRoot(dot(normal, normal));
  // N.V = N.H' - N.L, with H' = V + L of the first sun.
  float nDotV = max((dot(normal, vHalfSun0) - dot(normal, vToSun0.xyz)) * inverseN, 1.0e-4);
  View view = View(normal, inverseN, nDotV);
