// Metals do not scatter the sky's light.
//! main
  diffuse *= uReflectance.x;
