// The interpolated normal, to unit length.
//! main
  vec3 normal = normalize(vNormal);
