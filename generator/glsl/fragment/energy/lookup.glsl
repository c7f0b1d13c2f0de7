// SPDX-License-Identifier: MIT
// What is scattered between facets: what the sky's lookup texture said of it.
//! main
  surface.compensation = compensation;
