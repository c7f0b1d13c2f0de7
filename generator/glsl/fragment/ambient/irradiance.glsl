// SPDX-License-Identifier: MIT
// The sky's irradiance, by nine coefficients. Their cosine lobe, the basis' constants and 1/pi lie in the
// coefficients (packAmbient).
//! declarations
uniform vec3 uSky[9]; // lights: linear; order 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2
//! functions
// n: unit, world space. Returns irradiance over pi: the linear radiance of a white surface.
vec3 skyIrradiance(vec3 n) {
  // Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001, equation 13.
  return uSky[0] + uSky[1] * n.y + uSky[2] * n.z + uSky[3] * n.x
       + uSky[4] * (n.x * n.y) + uSky[5] * (n.y * n.z) + uSky[6] * (3.0 * n.z * n.z - 1.0)
       + uSky[7] * (n.x * n.z) + uSky[8] * (n.x * n.x - n.y * n.y);
}
//! main
  vec3 irradiance = max(skyIrradiance(normal), 0.0); // nine coefficients can ring below 0
