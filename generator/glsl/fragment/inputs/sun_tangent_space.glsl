// SPDX-License-Identifier: MIT
// One sun in tangent space: its direction with Schlick's (1 - V.H)^5, and V + L.
//! declarations
varying vec4 vTo${light};
varying vec3 vHalf${light};
