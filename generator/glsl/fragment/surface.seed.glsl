// What a light needs to know of the surface; the specular layer takes its share from each channel.
//! functions
struct Surface {
  vec3 diffuse; // (1 - metalness) (1 - F0)
  float metal; // metalness
  float dielectric; // 0.04 (1 - metalness)
  float slope; // 1 - alpha^2
  vec2 smith; // coefficients of the shadowing
  float gain; // what the shadowing's coefficients do not hold
};
