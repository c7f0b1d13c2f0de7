// SPDX-License-Identifier: MIT
// Fills all hooks; two of them share a value, and the vertex hook hands one on.
//! declarations
uniform vec4 uWave; // user: amplitude, m; three more
varying float vHeight;
uniform vec4 uTint; // user: factor
//! vertex
vec3 onVertex(vec3 position) {
  vHeight = position.y;
  return position + uWave.xyz;
}
//! base-color
vec4 onBaseColor(vec4 base) {
  return base * uTint;
}
//! surface
const float kWet = 0.25;

float wetness(float roughness) {
  return roughness * kWet;
}

void onSurface(inout vec3 normal, inout float roughness) {
  normal = normalize(normal + vec3(0.0, 0.1, 0.0));
  roughness = wetness(roughness);
}
//! light
vec3 onLight(vec3 color) {
  return color * (uTint.w + vHeight);
}
