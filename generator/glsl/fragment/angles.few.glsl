// What a light's direction means to a surface, for every BRDF. H = V + L is never built: for unit vectors
// |V + L|^2 = 2 + 2 V.L, and N.(V + L) = N.V + N.L.
//! functions
// normal and toCamera times their scale are unit, as toLight is. Returns N.L clamped; (N.(V+L))^2;
// |V+L|^2, kept off 0; Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, vec3 toCamera, vec2 scale, float nDotV, vec3 toLight) {
  float nDotL = max(scale.x * dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  float h2 = (dot(toCamera, toLight) * scale.y) * 2.0 + 2.000002;
  float x = 1.0 - root(0.25 * h2);
  float x2 = x * x;
  return vec4(nDotL, nDotH * nDotH, h2, x2 * x2 * x);
}
