// SPDX-License-Identifier: MIT
// Spot lights: KHR_lights_punctual. A point light has scale 0 and offset 1.
//! functions
// axis: where the light shines, unit. cone: scale and offset that packPunctualLight made from both angles.
float coneAttenuation(vec3 toLight, vec3 axis, vec2 cone) {
  // KHR_lights_punctual, "Inner and Outer Cone Angles".
  float c = clamp(cone.y - dot(toLight, axis) * cone.x, 0.0, 1.0);
  return c * c;
}

// See pointLight and coneAttenuation.
Light spotLight(vec4 position, vec3 intensity, vec3 axis, vec2 cone, vec3 toCamera) {
  Light light = pointLight(position, intensity, toCamera);
  light.radiance *= coneAttenuation(light.direction, axis, cone);
  return light;
}
