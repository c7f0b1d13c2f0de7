// One sun whose vectors are in tangent space.
//! declarations
uniform vec3 u${light}Radiance; // lights: linear irradiance / pi
//! main
  vec4 angles${light} = lightAngles(normal, inverseLength, vTo${light}, vHalf${light});
  addLight(u${light}Radiance, angles${light}, nDotV, surface, diffuse, specular);
