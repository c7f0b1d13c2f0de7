// SPDX-License-Identifier: MIT
// Point lights, and spot lights but for their cone: KHR_lights_punctual.
//! functions
// position: from the eye, world space, m; 1 / range^2, 0 where the range is infinite. intensity: over pi. toCamera:
// from the surface, m.
Light pointLight(vec4 position, vec3 intensity, vec3 toCamera) {
  vec3 toLight = position.xyz + toCamera;
  float distance2 = max(dot(toLight, toLight), 1.0e-8);
  float inverseLength = inverseSquareRoot(distance2);
  // Inverse square with a window at the range: KHR_lights_punctual, "Range Property".
  float d = distance2 * position.w;
  float attenuation = max(1.0 - d * d, 0.0) * (inverseLength * inverseLength);
  return Light(toLight, intensity, inverseLength, attenuation);
}
