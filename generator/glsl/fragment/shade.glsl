// The render equation's sum.
//! main
  vec3 color = base.rgb * diffuse + specular;
