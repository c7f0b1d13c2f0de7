// Occlusion dims ambient light only, its mirror image included (glTF 2.0, 3.9.3, speaks of indirect light).
//! main
  skyShare *= occlusion;
