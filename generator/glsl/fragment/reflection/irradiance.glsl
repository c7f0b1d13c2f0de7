// SPDX-License-Identifier: MIT
// The sky's irradiance: two rectangles beside the levels of reflection/atlas, which are fewer instructions than nine
// coefficients. Each holds a half of the sphere, by a projection that needs no division.
//! functions
// Two rectangles of an eighth of the atlas' width and height.
const vec2 kIrradianceUpper = vec2(0.8125, 0.75); // the middle of the upper half's: 13 / 16, 3 / 4
const vec2 kIrradianceLower = vec2(0.9375, 0.75); // the middle of the lower half's: 15 / 16, 3 / 4
const float kIrradianceHalf = 0.0546875; // half of what is not border: 7 / 8 / 16

// n: unit, world space. Returns irradiance over pi: the linear radiance of a white surface.
vec3 skyIrradiance(vec3 n) {
  // At (x, z) (1 - |y| / 2): any map that does not fold will do, and this one takes no reciprocal.
  float reach = kIrradianceHalf - 0.5 * kIrradianceHalf * abs(n.y);
  float u = n.y < 0.0 ? kIrradianceLower.x : kIrradianceUpper.x;
  vec4 texel = texture2D(uReflectionTexture, vec2(n.x * reach + u, n.z * reach + kIrradianceUpper.y));
  vec3 root = texel.rgb * (texel.a * uReflectionScale);
  return root * root;
}
//! main
  vec3 irradiance = skyIrradiance(normal);
