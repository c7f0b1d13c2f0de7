// Ambient light alone.
//! main
  vec3 color = base.rgb * diffuse;
