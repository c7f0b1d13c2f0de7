// SPDX-License-Identifier: MIT
// Where the application's effect puts the vertex.
//! main
  position = ${call};
