// One sun beside a sky's mirror image (sky_sum.glsl).
//! declarations
uniform vec3 u${light}Direction; // lights: towards the sun, unit, world space
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  vec4 angles${light} = lightAngles(normal, nDotV, toCamera, u${light}Direction);
  addLight(u${light}Radiance, angles${light}, nDotV, surface, base.rgb, color);
