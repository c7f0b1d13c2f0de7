// SPDX-License-Identifier: MIT
// The frame in which the normal map is flat: light vectors are brought into it, so that its texels need
// no turning.
//! main
  toCamera = normalize(toCamera);
  vec3 bitangent = cross(normal, tangent) * aTangent.w;
  vec3 eye = vec3(dot(toCamera, tangent), dot(toCamera, bitangent), dot(toCamera, normal));
