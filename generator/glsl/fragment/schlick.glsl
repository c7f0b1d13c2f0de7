// glTF's BRDF with Schlick-GGX visibility, k = alpha / 2 (Karis, "Real Shading in Unreal Engine 4", 2013):
// no square roots.
//! functions
struct Surface {
  float diffuse; // 0.96 (1 - metalness)
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
  float rim = lobe * light.w;
  float face = lobe - rim;
  diffuse += radiance * ((nDotL - nDotL * light.w) * surface.diffuse + face * surface.metal);
  specular += radiance * (face * surface.dielectric + rim);
}
