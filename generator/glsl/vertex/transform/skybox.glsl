// SPDX-License-Identifier: MIT
// One triangle over the whole screen at the far plane, and the direction that each pixel looks into.
//! declarations
attribute vec3 aPosition; // clip space: (-1,-1), (3,-1), (-1,3)
uniform mat3 uClipToSky; // frame: (x, y, 1) in clip space to a direction in the sky
varying vec3 vDirection;
//! main
  vDirection = uClipToSky * vec3(aPosition.xy, 1.0);
  gl_Position = vec4(aPosition.xy, 1.0, 1.0);
