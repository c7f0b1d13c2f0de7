// Metalness and roughness by texture.
//! functions
// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's mirror image has no size.
Surface makeSurface(vec3 base, float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = r * r * r * r;
  float k = 0.125 * (roughness + 1.0) * (roughness + 1.0);
  float dielectric = 0.04 - 0.04 * metallic;
  float scattered = 1.0 - metallic;
  float diffuse = scattered - scattered * dielectric;
  vec2 smith = vec2(1.0 - k, k);
  float gain = 0.25 * alpha2;
  return Surface(base, diffuse, scattered * metallic, metallic, dielectric, 1.0 - alpha2, smith, gain);
}
//! main
  Surface surface = makeSurface(base.rgb, metallic, roughness);
