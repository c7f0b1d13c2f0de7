// What a light's direction means to a surface, for every BRDF. H = V + L is never built: for unit vectors
// |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L. The root of a quarter of |V + L|^2 is root.vc4.glsl's, with
// the quarter in the exponent, so that gltf.vc4.glsl finds the same logarithm.
//! functions
// All vectors unit. Returns N.L clamped; (N.(V+L))^2; |V+L|^2, kept off 0; Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, float nDotV, vec3 toCamera, vec3 toLight) {
  float nDotL = max(dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  float vDotL = dot(toCamera, toLight) + 1.000001;
  float h2 = vDotL + vDotL;
  float x = 1.0 - exp2(0.50001 * log2(h2) - 1.0);
  float x2 = x * x;
  return vec4(nDotL, nDotH * nDotH, h2, x2 * x2 * x);
}
