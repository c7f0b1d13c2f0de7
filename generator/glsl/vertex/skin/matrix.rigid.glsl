// SPDX-License-Identifier: MIT
// Where its one joint takes the vertex: the rows of a matrix, from the bind pose to model space.
//! declarations
attribute vec4 aJoints; // x: where the joint's rows begin in uJoints
//! main
  int skinJoint = int(aJoints.x);
  vec4 skinX = uJoints[skinJoint];
  vec4 skinY = uJoints[skinJoint + 1];
  vec4 skinZ = uJoints[skinJoint + 2];
