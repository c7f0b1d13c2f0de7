// The BRDF of glTF 2.0, appendix B: GGX, height-correlated Smith, Schlick; dielectric and metal mixed by
// metalness. generator/README.md derives the form.
//! functions
struct Surface {
  float diffuse; // 0.96 (1 - metalness)
  float metal; // metalness
  float dielectric; // 0.04 (1 - metalness)
  float alpha2; // roughness^4
  float slope; // 1 - alpha2
};

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float nDotL = light.x;
  float smithV = nDotL * sqrt(nDotV * nDotV * surface.slope + surface.alpha2);
  float smithL = nDotV * sqrt(nDotL * nDotL * surface.slope + surface.alpha2);
  float width = light.z - light.y * surface.slope;
  float lobe = 0.5 * surface.alpha2 * nDotL * light.z * light.z / (width * width * (smithV + smithL));
  float rim = lobe * light.w;
  float face = lobe - rim;
  diffuse += radiance * ((nDotL - nDotL * light.w) * surface.diffuse + face * surface.metal);
  specular += radiance * (face * surface.dielectric + rim);
}
