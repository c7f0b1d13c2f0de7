// What the sky sends to a surface, over pi: two squares in a corner of the texture of sky_atlas.glsl, which are
// fewer instructions than nine coefficients. Each holds a half of the sphere, projected from the other pole.
//! functions
// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  vec2 p = n.xz * inverse(abs(n.y) + 1.0);
  vec2 point = vec2(p.x * 0.0546875 + (n.y < 0.0 ? 0.9375 : 0.8125), p.y * 0.03351643 + 0.9576122);
  vec4 texel = texture2D(uSpecularSky, point);
  vec3 root = (uSpecularScale * texel.a) * texel.rgb;
  return root * root;
}
//! main
  vec3 irradiance = skyLight(normal);
