// What a light's direction means to a surface, for every BRDF. H = V + L is never built:
// |V + L|^2 = |V|^2 + 1 + 2 V.L, and N.(V + L) = N.V + N.L.
//! functions
// normal and toCamera times their scale are unit, as toLight is. squares: |normal|^2; 1 + |V|^2, kept off 2.
// facing: N.V of the unscaled normal. Returns N.L clamped; (N.(V+L))^2 and |V+L|^2, both times |normal|^2;
// Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, vec3 toCamera, vec2 squares, vec2 scale, float facing, vec3 toLight) {
  float facingLight = max(dot(normal, toLight), 0.0);
  float nDotH = facingLight + facing;
  float h2 = (dot(toCamera, toLight) * scale.y) * 2.0 + squares.y;
  float x = 1.0 - root(0.25 * h2);
  float x2 = x * x;
  return vec4(facingLight * scale.x, nDotH * nDotH, squares.x * h2, x2 * x2 * x);
}
