// SPDX-License-Identifier: MIT
// The application's effect on the surface, before any light.
//! main
  ${call};
