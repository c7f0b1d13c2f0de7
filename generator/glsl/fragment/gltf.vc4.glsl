// The lobe of gltf.glsl with its quotient as a difference of logarithms: three products fewer, two sums more. On
// VideoCore IV products are scarcer, and |V+L|^2 has its logarithm already where lightAngles takes its root.
//! functions
// pi D V. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float smithL = nDotV * root(light.x * (light.x * surface.smith.x) + surface.smith.y);
  float smithV = light.x * root(nDotV * (surface.smith.x * nDotV) + surface.smith.y);
  float width = light.z - light.y * surface.slope;
  float h = log2(light.z);
  return surface.gain * exp2((h + h) - log2((smithV + smithL) * (width * width)));
}
