// SPDX-License-Identifier: MIT
// Times the vertex colour, which is linear.
//! main
  base *= vColor;
