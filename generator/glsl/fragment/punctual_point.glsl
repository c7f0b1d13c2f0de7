// Punctual lights that shine everywhere: KHR_lights_punctual, point.
//! functions
// Inverse square with a window at the range (KHR_lights_punctual, "Range Property"). distance2 in m^2;
// inverseRange2 = 1 / range^2, 0 where the range is infinite.
float distanceAttenuation(float distance2, float inverseRange2) {
  float d = distance2 * inverseRange2;
  return clamp(1.0 - d * d, 0.0, 1.0) / max(distance2, 1.0e-8);
}
