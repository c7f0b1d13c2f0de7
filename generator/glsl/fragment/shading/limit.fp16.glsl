// SPDX-License-Identifier: MIT
// Light beyond any tone map's white, which could overflow in it.
//! main
  color = min(color, 64.0);
