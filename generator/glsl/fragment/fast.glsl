// glTF's BRDF with the visibility of Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", 2017:
// no square roots.
//! functions
struct Surface {
  float diffuse; // 0.96 (1 - metalness)
  float metal; // metalness
  float dielectric; // 0.04 (1 - metalness)
  float alpha; // roughness^2
  float alpha2; // roughness^4
};

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float nDotL = light.x;
  float smith = mix(2.0 * nDotL * nDotV, nDotL + nDotV, surface.alpha);
  float width = light.z - light.y + light.y * surface.alpha2;
  float lobe = 0.5 * surface.alpha2 * nDotL * light.z * light.z / (width * width * smith);
  float rim = lobe * light.w;
  float face = lobe - rim;
  diffuse += radiance * ((nDotL - nDotL * light.w) * surface.diffuse + face * surface.metal);
  specular += radiance * (face * surface.dielectric + rim);
}
