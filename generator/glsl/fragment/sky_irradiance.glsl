// What the sky sends to a surface, over pi: two rectangles beside the levels of sky_atlas.glsl, which are fewer
// instructions than nine coefficients. Each holds a half of the sphere, by a projection that needs no division.
//! functions
// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  float reach = 0.0546875 - 0.02734375 * abs(n.y);
  vec2 point = vec2(n.x * reach + (n.y < 0.0 ? 0.9375 : 0.8125), n.z * reach + 0.75);
  vec4 texel = texture2D(uReflectionTexture, point);
  vec3 root = texel.rgb * (texel.a * uReflectionScale);
  return root * root;
}
//! main
  vec3 irradiance = skyLight(normal);
