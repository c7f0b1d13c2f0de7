// SPDX-License-Identifier: MIT
// Back faces are lit from their own side, for drivers whose gl_FrontFacing lies: a face is a back face
// where its normal looks away from the eye.
//! main
  if (dot(vNormal, vToCamera) < 0.0) normal = -normal;
