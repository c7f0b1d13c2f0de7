// SPDX-License-Identifier: MIT
// The vector to the eye from where joints or an effect put the vertex, in world space, not normalised.
//! declarations
uniform mat4 uModel; // object: model space to world space
uniform vec3 uCameraPosition; // frame: world space
//! main
  vec3 toCamera = uCameraPosition - (uModel * vec4(position, 1.0)).xyz;
