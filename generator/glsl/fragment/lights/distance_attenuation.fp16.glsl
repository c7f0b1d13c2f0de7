// SPDX-License-Identifier: MIT
// Point lights, and spot lights but for their cone: KHR_lights_punctual, by scaled lengths.
//! functions
// distance2, inverseRange2: in squares of the scaled unit; inverseRange2 is 0 where the range is infinite.
float distanceAttenuation(float distance2, float inverseRange2) {
  // Inverse square with a window at the range: KHR_lights_punctual, "Range Property". The ratio is clipped before it is
  // squared, which could overflow.
  float d = min(distance2 * inverseRange2, 1.0);
  return (1.0 - d * d) / distance2;
}

// toLight: scaled, at most 60 long. intensity: over pi. The radiance ends where any surface is white.
Light pointLight(vec3 toLight, vec3 intensity, float inverseRange2) {
  float distance2 = max(dot(toLight, toLight), 1.0e-4);
  vec3 direction = toLight * inverseSquareRoot(distance2);
  return Light(direction, min(intensity * distanceAttenuation(distance2, inverseRange2), 16.0));
}
