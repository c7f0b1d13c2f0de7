// The sky's irradiance on a surface that faces n, over pi: Ramamoorthi and Hanrahan, "An Efficient
// Representation for Irradiance Environment Maps", 2001, equation 13. Their cosine lobe, the basis'
// constants and 1/pi lie in the coefficients (packSky). Nine coefficients can ring below 0.
//! declarations
uniform vec3 uSky[9]; // lights: linear; order 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2
//! functions
// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  return uSky[0] + uSky[1] * n.y + uSky[2] * n.z + uSky[3] * n.x
       + uSky[4] * (n.x * n.y) + uSky[5] * (n.y * n.z) + uSky[6] * (3.0 * n.z * n.z - 1.0)
       + uSky[7] * (n.x * n.z) + uSky[8] * (n.x * n.x - n.y * n.y);
}
//! main
  vec3 diffuse = max(skyLight(normal), 0.0);
