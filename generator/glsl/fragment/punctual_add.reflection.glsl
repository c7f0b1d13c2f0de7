// One punctual light's share, beside a sky's mirror image (sky_sum.glsl).
//! main
  vec4 angles${light} = lightAngles(normal, nDotV, toCamera, to${light});
  addLight(radiance${light}, angles${light}, nDotV, surface, base.rgb, color);
