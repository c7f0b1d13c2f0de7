// SPDX-License-Identifier: MIT
// Once, after all lights are summed.
//! main
  color = toneMap(color);
