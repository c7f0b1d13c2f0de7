// SPDX-License-Identifier: MIT
// Schlick's term of all suns at once.
//! main
  vec4 x = 1.0 - sqrt(0.5 * vVDotL + 0.5);
  vFresnel = x * x * x * x * x;
