// Once, after all lights are summed.
//! main
  color = toneMap(color);
