// SPDX-License-Identifier: MIT
// What the surface reflects of all light. One sum, tinted at once: what is live while textures are waited for takes
// three registers instead of six.
//! functions
struct Sum {
  vec3 color; // linear radiance
};
