// One light's share of the two sums. Of the lobe, Schlick's term goes to the rim, which nothing tints; the
// rest is F0's: the base colour by metalness, and 4 % of a dielectric.
//! functions
// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float mirror = lobe(light, nDotV, surface);
  float rim = light.w * mirror;
  float face = mirror - rim;
  float entering = light.x - light.w * light.x;
  specular += (surface.dielectric * face + rim) * radiance;
  vec3 kept = entering * surface.tinted * surface.base;
  diffuse += (surface.diffuse * entering + face * surface.metal - kept) * radiance;
}
