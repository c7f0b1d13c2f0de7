// One light's share of the two sums. Of the lobe, Schlick's term goes to the rim, which nothing tints; the
// rest is F0's: a metal's base colour, or 4 % of a dielectric. generator/README.md shows that this is glTF's
// mix of dielectric and metal.
//! functions
// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float entering = light.x - light.x * light.w;
  float mirror = lobe(light, nDotV, surface);
  diffuse += radiance * (entering * (surface.metal * mirror + surface.diffuse));
  specular += radiance * (mirror * (light.x - entering * surface.clear));
}
