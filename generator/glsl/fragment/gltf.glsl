// The specular lobe of glTF 2.0, appendix B: GGX with height-correlated Smith shadowing.
// generator/README.md derives the form.
//! functions
// pi D V N.L. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float smithV = light.x * root(nDotV * nDotV * surface.smith.x + surface.smith.y);
  float smithL = nDotV * root(light.x * light.x * surface.smith.x + surface.smith.y);
  float width = light.z - light.y * surface.slope;
  return surface.gain * light.x * light.z * light.z * inverse(width * width * (smithV + smithL));
}
