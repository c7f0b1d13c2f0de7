// SPDX-License-Identifier: MIT
// V.L and Schlick's (1 - V.H)^5 of each sun, once a vertex; the eye vector is normalised here already.
//! declarations
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;
//! main
  toCamera = normalize(toCamera);
  vToCamera = toCamera;
  vVDotL = vec4(0.0);
