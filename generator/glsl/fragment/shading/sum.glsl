// SPDX-License-Identifier: MIT
// All light.
//! main
  vec3 color = base.rgb * sum.diffuse + sum.specular;
