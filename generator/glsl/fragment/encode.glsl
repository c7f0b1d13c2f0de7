// Once, at the end: the framebuffer does not do it.
//! main
  color = encodeDisplay(color);
