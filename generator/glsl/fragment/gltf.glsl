// The specular lobe of glTF 2.0, appendix B: GGX with height-correlated Smith shadowing.
// generator/README.md derives the form.
//! functions
// pi D V. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float width = light.z - light.y * surface.slope;
  float smithL = nDotV * root(light.x * (light.x * surface.smith.x) + surface.smith.y);
  float smithV = light.x * root(nDotV * (surface.smith.x * nDotV) + surface.smith.y);
  return (light.z * light.z) * surface.gain * inverse((smithV + smithL) * (width * width));
}
