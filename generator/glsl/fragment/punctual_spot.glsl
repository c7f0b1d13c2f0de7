// One punctual light's cone.
//! declarations
uniform vec3 u${light}Axis; // lights: where it shines, unit, world space
uniform vec2 u${light}Cone; // lights: scale and offset
//! main
  radiance${light} *= coneAttenuation(to${light}, u${light}Axis, u${light}Cone);
