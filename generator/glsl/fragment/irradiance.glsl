// What the sky sends to a white surface, before metalness and occlusion take their share.
//! main
  vec3 irradiance = diffuse;
