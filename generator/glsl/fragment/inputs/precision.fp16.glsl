// SPDX-License-Identifier: MIT
// mediump, for GPUs whose fragments have 16 bits whatever a program asks for.
//! declarations
precision mediump float;
