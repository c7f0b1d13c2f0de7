// SPDX-License-Identifier: MIT
// What the surface reflects of all light.
//! functions
struct Sum {
  vec3 diffuse; // what the base colour tints, a metal's specular light included
  vec3 specular; // what it does not tint
};
