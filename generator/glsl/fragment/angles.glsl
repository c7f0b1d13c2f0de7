// What a light's direction means to a surface, for every BRDF. H = V + L is never built: for unit vectors
// |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L.
//! functions
// All vectors unit. Returns N.L clamped; (N.(V+L))^2; |V+L|^2, kept off 0; Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, float nDotV, vec3 toCamera, vec3 toLight) {
  float nDotL = max(dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  float h2 = 2.0 * dot(toCamera, toLight) + 2.000002;
  float x = 1.0 - root(0.25 * h2);
  float x2 = x * x;
  return vec4(nDotL, nDotH * nDotH, h2, x2 * x2 * x);
}
