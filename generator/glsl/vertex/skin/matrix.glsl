// SPDX-License-Identifier: MIT
// Where joints take the vertex: the rows of a matrix, from the bind pose to model space. glTF 2.0, 3.7.3.3: linear blending.
//! declarations
attribute vec4 aJoints; // where each joint's rows begin in uJoints
attribute vec4 aWeights; // add up to 1
//! main
  int skinJoint;
  vec4 skinX = vec4(0.0);
  vec4 skinY = vec4(0.0);
  vec4 skinZ = vec4(0.0);
