// SPDX-License-Identifier: MIT
// Occlusion dims ambient light only, the reflection included (glTF 2.0, 3.9.3, speaks of indirect light).
//! main
  share.scattered *= occlusion;
  share.squared *= occlusion;
  share.tinted *= occlusion;
  share.untinted *= occlusion;
