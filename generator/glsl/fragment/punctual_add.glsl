// One punctual light's share.
//! main
  vec4 angles${light} = lightAngles(normal, nDotV, toCamera, to${light});
  addLight(radiance${light}, angles${light}, nDotV, surface, diffuse, specular);
