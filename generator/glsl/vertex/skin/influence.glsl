// SPDX-License-Identifier: MIT
// One joint's share of it.
//! main
  skinJoint = int(aJoints.${lane});
  skinX += aWeights.${lane} * uJoints[skinJoint];
  skinY += aWeights.${lane} * uJoints[skinJoint + 1];
  skinZ += aWeights.${lane} * uJoints[skinJoint + 2];
