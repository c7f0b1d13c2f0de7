// Sums that lights are added to. `diffuse` is what the base colour tints, a metal's mirror light included;
// `specular` is what it does not tint.
//! main
  vec3 diffuse = vec3(0.0);
