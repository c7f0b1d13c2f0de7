// SPDX-License-Identifier: MIT
// The pixel, opaque.
//! main
  gl_FragColor = vec4(color, 1.0);
