// The sky's light, by what it becomes: scattered, mirrored with the base colour's tint, and mirrored without.
//! main
  vec3 diffuse = irradiance * skyShare.x + mirrored * skyShare.y;
  vec3 specular = mirrored * skyShare.z;
