// The light of add_light.seed.glsl beside a sky's mirror image, tinted at once (sky_sum.glsl says why).
//! functions
// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, vec3 base, inout vec3 color) {
  float mirror = lobe(light, nDotV, surface);
  float rim = light.w * mirror;
  float face = mirror - rim;
  float entering = light.x - light.w * light.x;
  vec3 kept = entering * surface.tinted * surface.base;
  vec3 tinted = surface.diffuse * entering + face * surface.metal - kept;
  color += (base * tinted + (surface.dielectric * face + rim)) * radiance;
}
