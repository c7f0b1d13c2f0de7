// The specular lobe of glTF 2.0, appendix B: GGX with height-correlated Smith shadowing.
// generator/README.md derives the form.
//! functions
// pi D V N.L. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float smithV = root((nDotV * surface.smith.x) * nDotV + surface.smith.y) * light.x;
  float width = light.z - surface.slope * light.y;
  float smithL = nDotV * root(light.x * (light.x * surface.smith.x) + surface.smith.y);
  return light.z * light.z * surface.gain * light.x * inverse(width * width * (smithV + smithL));
}
