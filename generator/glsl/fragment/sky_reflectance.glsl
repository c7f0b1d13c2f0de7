// Metals do not scatter the sky's light.
//! main
  diffuse *= 0.96 - 0.96 * metallic;
