// SPDX-License-Identifier: MIT
// One spot light's cone.
//! declarations
uniform vec3 u${light}Axis; // lights: where it shines, unit, world space
uniform vec2 u${light}Cone; // lights: scale and offset
//! main
  light${light}.radiance *= coneAttenuation(light${light}.direction, u${light}Axis, u${light}Cone);
