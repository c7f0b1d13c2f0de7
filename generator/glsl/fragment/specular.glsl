// Light that the base colour does not tint.
//! main
  vec3 specular = vec3(0.0);
