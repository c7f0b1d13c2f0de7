// SPDX-License-Identifier: MIT
// The pixel, to be blended over what is there; alpha is straight.
//! main
  gl_FragColor = vec4(color, base.a);
