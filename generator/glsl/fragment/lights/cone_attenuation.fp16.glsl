// SPDX-License-Identifier: MIT
// Spot lights: KHR_lights_punctual. A point light has scale 0 and offset 1.
//! functions
// axis: where the light shines, unit. cone: scale and offset that fitToFp16 made.
float coneAttenuation(vec3 toLight, vec3 axis, vec2 cone) {
  // KHR_lights_punctual, "Inner and Outer Cone Angles", by 1 - cos = |toLight + axis|^2 / 2: a narrow cone's cosines
  // differ in few digits.
  vec3 aside = toLight + axis;
  float c = clamp(cone.y - dot(aside, aside) * cone.x, 0.0, 1.0);
  return c * c;
}

// See pointLight and coneAttenuation.
Light spotLight(vec3 toLight, vec3 intensity, float inverseRange2, vec3 axis, vec2 cone) {
  Light light = pointLight(toLight, intensity, inverseRange2);
  light.radiance *= coneAttenuation(light.direction, axis, cone);
  return light;
}
