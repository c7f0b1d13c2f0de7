// The specular lobe of the FrankenShader that this library is named after: Schlick-GGX shadowing with
// k = (roughness + 1)^2 / 8 (Karis, "Real Shading in Unreal Engine 4", 2013), and 4 N.L N.V, which it
// divides by, kept above 0.001.
//! functions
// pi D V N.L. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float width = light.z - light.y * surface.slope;
  float smithV = nDotV * surface.smith.x + surface.smith.y;
  float smithL = surface.smith.x * light.x + surface.smith.y;
  float kept = min(nDotV * (4000.0 * light.x), 1.0);
  return light.x * kept * surface.gain * inverse(width * width * smithV * smithL) * (light.z * light.z);
}
