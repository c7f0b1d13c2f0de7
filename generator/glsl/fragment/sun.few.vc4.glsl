// One sun: its direction is the same everywhere.
//! declarations
uniform vec3 u${light}Direction; // lights: towards the sun, unit, world space
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  vec4 angles${light} = lightAngles(normal, vToCamera, squares, scale, facing, u${light}Direction);
  addLight(u${light}Radiance, angles${light}, nDotV, surface, diffuse, specular);
