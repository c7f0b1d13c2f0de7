// The specular lobe of the FrankenShader that this library is named after: Schlick-GGX shadowing with
// k = (roughness + 1)^2 / 8 (Karis, "Real Shading in Unreal Engine 4", 2013), and 4 N.L N.V, which it
// divides by, kept above 0.001.
//! functions
// pi D V N.L. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float kept = min(4000.0 * light.x * nDotV, 1.0);
  float width = light.z - light.y * surface.slope;
  float smithV = nDotV * surface.smith.x + surface.smith.y;
  float smithL = light.x * surface.smith.x + surface.smith.y;
  return light.x * kept * surface.gain * inverse(width * width * smithV * smithL) * (light.z * light.z);
}
