// SPDX-License-Identifier: MIT
// The normal in world space, turned by the joints: by the inverse transpose of the blended matrix, as its cofactors up to a
// positive factor. Where a joint is scaled to nothing it stays as it was bound.
//! declarations
attribute vec3 aNormal;
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
//! main
  vec3 skinCofactorX = cross(skinY.xyz, skinZ.xyz);
  vec3 skinCofactorY = cross(skinZ.xyz, skinX.xyz);
  vec3 skinCofactorZ = cross(skinX.xyz, skinY.xyz);
  vec3 skinnedNormal = vec3(dot(skinCofactorX, aNormal), dot(skinCofactorY, aNormal), dot(skinCofactorZ, aNormal));
  skinnedNormal = (dot(skinX.xyz, skinCofactorX) < 0.0 ? -skinnedNormal : skinnedNormal) + 1.0e-15 * aNormal;
  vec3 normal = normalize(uNormalMatrix * skinnedNormal);
