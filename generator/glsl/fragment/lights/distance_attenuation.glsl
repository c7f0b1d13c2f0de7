// SPDX-License-Identifier: MIT
// Point lights, and spot lights but for their cone: KHR_lights_punctual.
//! functions
// distance2: in m^2. inverseRange2: 1 / range^2, 0 where the range is infinite.
float distanceAttenuation(float distance2, float inverseRange2) {
  // Inverse square with a window at the range: KHR_lights_punctual, "Range Property".
  float d = distance2 * inverseRange2;
  return clamp(1.0 - d * d, 0.0, 1.0) / max(distance2, 1.0e-8);
}

// position: from the eye, world space, m; 1 / range^2. intensity: over pi. toCamera: from the surface, m.
Light pointLight(vec4 position, vec3 intensity, vec3 toCamera) {
  vec3 toLight = position.xyz + toCamera;
  float distance2 = dot(toLight, toLight);
  vec3 direction = toLight * inverseSquareRoot(max(distance2, 1.0e-8));
  return Light(direction, intensity * distanceAttenuation(distance2, position.w));
}
