// The specular lobe with Schlick-GGX shadowing, k = alpha / 2 (Karis, "Real Shading in Unreal Engine 4",
// 2013).
//! functions
// pi D V. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float smithV = nDotV * surface.smith.x + surface.smith.y;
  float smithL = light.x * surface.smith.x + surface.smith.y;
  float width = light.z - light.y * surface.slope;
  return surface.gain * light.z * light.z * inverse(width * width * smithV * smithL);
}
