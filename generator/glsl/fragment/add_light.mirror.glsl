// The light of add_light.glsl beside a sky's mirror image, tinted at once (sky_sum.glsl says why).
//! functions
// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, vec3 base, inout vec3 color) {
  float entering = light.x - light.x * light.w;
  float mirror = lobe(light, nDotV, surface);
  float tinted = (surface.diffuse + mirror * surface.metal) * entering;
  color += radiance * (base * tinted + mirror * (light.x - surface.clear * entering));
}
