// SPDX-License-Identifier: MIT
// The application's effect on the base colour.
//! main
  base = ${call};
