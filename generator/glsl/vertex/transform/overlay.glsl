// SPDX-License-Identifier: MIT
// Where a corner of an overlay is on the screen: in front of everything, in units of its own (pixels, say).
//! declarations
attribute vec3 aPosition; // z is not used
uniform mat3 uOverlay; // object: (x, y, 1) in the overlay's units to clip space
//! main
  gl_Position = vec4((uOverlay * vec3(aPosition.xy, 1.0)).xy, 0.0, 1.0);
