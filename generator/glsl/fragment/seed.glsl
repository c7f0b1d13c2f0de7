// The BRDF of the FrankenShader that this library is named after: GGX, Schlick-GGX with
// k = (roughness + 1)^2 / 8 (Karis, "Real Shading in Unreal Engine 4", 2013), its denominator
// 4 N.L N.V kept above 0.001. generator/README.md derives the form.
//! functions
struct Surface {
  vec3 diffuse; // (1 - metalness) (1 - F0)
  float metal; // metalness
  float dielectric; // 0.04 (1 - metalness)
  float slope; // 1 - alpha^2
  vec2 smith; // 1 - k, k
  float gain; // alpha^2 / 4
};

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float nDotL = light.x;
  float smithV = nDotV * surface.smith.x + surface.smith.y;
  float smithL = nDotL * surface.smith.x + surface.smith.y;
  float width = light.z - light.y * surface.slope;
  float lobe = surface.gain * nDotL * light.z * light.z / (width * width * (smithV * smithL));
  lobe *= min(4000.0 * nDotL * nDotV, 1.0);
  float rim = lobe * light.w;
  float face = lobe - rim;
  diffuse += radiance * ((nDotL - nDotL * light.w) * surface.diffuse + face * surface.metal);
  specular += radiance * (face * surface.dielectric + rim);
}
