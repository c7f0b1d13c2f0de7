// SPDX-License-Identifier: MIT
// The application's effect on the sum of light.
//! main
  color = ${call};
