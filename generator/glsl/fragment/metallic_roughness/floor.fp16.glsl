// SPDX-License-Identifier: MIT
// The smoothest surface whose highlight 16 bits can hold (kMinRoughnessFp16 in pack.h).
//! main
  roughness = max(roughness, 0.3);
