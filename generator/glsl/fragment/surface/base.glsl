// SPDX-License-Identifier: MIT
// The colour by which each light is tinted at once.
//! main
  surface.base = base.rgb;
