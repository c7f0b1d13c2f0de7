// SPDX-License-Identifier: MIT
// Once, at the end: the framebuffer does not do it.
//! main
  color = linearToDisplay(color);
