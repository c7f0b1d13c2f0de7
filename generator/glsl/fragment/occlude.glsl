// Occlusion dims ambient light only.
//! main
  diffuse *= occlusion;
