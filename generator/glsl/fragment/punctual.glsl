// One punctual light. Its position is given from the eye, so that the vector to the eye serves it too.
//! declarations
uniform vec4 u${light}Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 u${light}Radiance; // lights: linear intensity / pi
//! main
  vec3 to${light} = u${light}Position.xyz + vToCamera;
  float distance${light} = dot(to${light}, to${light});
  to${light} *= inverseRoot(max(distance${light}, 1.0e-8));
  vec3 radiance${light} = u${light}Radiance * distanceAttenuation(distance${light}, u${light}Position.w);
