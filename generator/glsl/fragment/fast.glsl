// The specular lobe with the shadowing of Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", 2017:
// glTF's without square roots.
//! functions
// pi D V. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float smith = light.x * nDotV * surface.smith.x + (light.x + nDotV) * surface.smith.y;
  float width = light.z - light.y * surface.slope;
  return surface.gain * light.z * light.z * inverse(width * width * smith);
}
