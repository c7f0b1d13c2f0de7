// SPDX-License-Identifier: MIT
// Spot lights: KHR_lights_punctual. A point light has scale 0 and offset 1.
//! functions
// cosine: of the angle between the axis and the way to the light. cone: scale and offset that packPunctualLight made
// from both angles.
float coneAttenuation(float cosine, vec2 cone) {
  // KHR_lights_punctual, "Inner and Outer Cone Angles".
  float c = clamp(cone.y - cosine * cone.x, 0.0, 1.0);
  return c * c;
}

// axis: where the light shines, unit. See pointLight and coneAttenuation.
Light spotLight(vec4 position, vec3 intensity, vec3 axis, vec2 cone, vec3 toCamera) {
  Light light = pointLight(position, intensity, toCamera);
  light.attenuation *= coneAttenuation(dot(light.direction, axis) * light.inverseLength, cone);
  return light;
}
