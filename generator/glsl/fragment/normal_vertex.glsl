// The interpolated normal, to unit length.
//! main
  vec3 normal = vNormal * inverseRoot(dot(vNormal, vNormal));
