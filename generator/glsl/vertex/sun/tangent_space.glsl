// SPDX-License-Identifier: MIT
// One sun in tangent space: its direction with Schlick's (1 - V.H)^5, and V + L, kept off 0.
//! declarations
uniform vec3 u${light}Direction; // lights: towards the sun, unit, world space
varying vec4 vTo${light};
varying vec3 vHalf${light};
//! main
  vec3 to${light} = vec3(dot(u${light}Direction, tangent), dot(u${light}Direction, bitangent), dot(u${light}Direction, normal));
  float x${light} = 1.0 - sqrt(0.5 * dot(toCamera, u${light}Direction) + 0.5);
  vTo${light} = vec4(to${light}, x${light} * x${light} * x${light} * x${light} * x${light});
  vHalf${light} = eye + to${light};
  vHalf${light}.z += 1.0e-4;
