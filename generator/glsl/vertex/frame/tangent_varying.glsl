// SPDX-License-Identifier: MIT
// Hands the tangent frame to the fragment shader, glTF's bitangent included: cross(N, T) * w. The scale of
// the normal map lies in the frame's x and y axes, where it costs nothing per pixel.
//! declarations
uniform float uNormalScale; // material: glTF's normalTexture.scale
varying vec3 vTangent;
varying vec3 vBitangent;
//! main
  vTangent = tangent * uNormalScale;
  vBitangent = cross(normal, tangent) * (aTangent.w * uNormalScale);
