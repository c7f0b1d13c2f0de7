// The light of add_light.glsl beside a sky's mirror image, tinted at once (sky_sum.glsl says why).
//! functions
// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, vec3 base, inout vec3 color) {
  float mirror = lobe(light, nDotV, surface);
  float entering = light.x - light.x * light.w;
  float tinted = (surface.diffuse + surface.metal * mirror) * entering;
  color += radiance * (mirror * (light.x - entering * surface.clear) + base * tinted);
}
