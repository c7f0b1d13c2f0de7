#version 100
// FrankenShader
//   skin/palette.32: 1
//   skin/matrix: 1
//   skin/influence: 4
//   transform/moved.skin: 1
//   transform/position.moved: 1
//   streams/uv0: 1
//   frame/normal.skin: 1
//   frame/to_camera.moved: 1
//   frame/tangent.skin: 1
//   frame/tangent_space: 1
//   sun/tangent_space: 1
//
// VERTEX SHADER
//
attribute vec4 aJoints; // where each joint's rows begin in uJoints
attribute vec4 aWeights; // add up to 1
attribute vec3 aPosition;
attribute vec2 aUv0;
attribute vec3 aNormal;
attribute vec4 aTangent; // xyz: direction of +U; w: +1 or -1, the bitangent's side

varying vec2 vUv0;
varying vec4 vToSun0;
varying vec3 vHalfSun0;

uniform vec3 uCameraPosition; // frame: world space
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform mat4 uModelViewProjection; // object: model space to clip space
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
uniform mat4 uModel; // object: model space to world space
uniform vec4 uJoints[96]; // skin: three rows of a matrix for each joint, from the bind pose to model space

vec3 safeNormalize(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1.0e-12));
}

void main() {
  int skinJoint;
  vec4 skinX = vec4(0.0);
  vec4 skinY = vec4(0.0);
  vec4 skinZ = vec4(0.0);
  skinJoint = int(aJoints.x);
  skinX += aWeights.x * uJoints[skinJoint];
  skinY += aWeights.x * uJoints[skinJoint + 1];
  skinZ += aWeights.x * uJoints[skinJoint + 2];
  skinJoint = int(aJoints.y);
  skinX += aWeights.y * uJoints[skinJoint];
  skinY += aWeights.y * uJoints[skinJoint + 1];
  skinZ += aWeights.y * uJoints[skinJoint + 2];
  skinJoint = int(aJoints.z);
  skinX += aWeights.z * uJoints[skinJoint];
  skinY += aWeights.z * uJoints[skinJoint + 1];
  skinZ += aWeights.z * uJoints[skinJoint + 2];
  skinJoint = int(aJoints.w);
  skinX += aWeights.w * uJoints[skinJoint];
  skinY += aWeights.w * uJoints[skinJoint + 1];
  skinZ += aWeights.w * uJoints[skinJoint + 2];

  vec4 boundPosition = vec4(aPosition, 1.0);
  vec3 position = vec3(dot(skinX, boundPosition), dot(skinY, boundPosition), dot(skinZ, boundPosition));
  gl_Position = uModelViewProjection * vec4(position, 1.0);

  vUv0 = aUv0;

  vec3 skinCofactorX = cross(skinY.xyz, skinZ.xyz);
  vec3 skinCofactorY = cross(skinZ.xyz, skinX.xyz);
  vec3 skinCofactorZ = cross(skinX.xyz, skinY.xyz);
  vec3 skinnedNormal = vec3(dot(skinCofactorX, aNormal), dot(skinCofactorY, aNormal), dot(skinCofactorZ, aNormal));
  skinnedNormal = (dot(skinX.xyz, skinCofactorX) < 0.0 ? -skinnedNormal : skinnedNormal) + 1.0e-15 * aNormal;
  vec3 normal = normalize(uNormalMatrix * skinnedNormal);
  vec3 toCamera = uCameraPosition - (uModel * vec4(position, 1.0)).xyz;
  vec3 skinnedTangent = vec3(dot(skinX.xyz, aTangent.xyz), dot(skinY.xyz, aTangent.xyz), dot(skinZ.xyz, aTangent.xyz));
  vec3 tangent = safeNormalize((uModel * vec4(skinnedTangent, 0.0)).xyz);
  toCamera = normalize(toCamera);
  vec3 bitangent = cross(normal, tangent) * aTangent.w;
  vec3 eye = vec3(dot(toCamera, tangent), dot(toCamera, bitangent), dot(toCamera, normal));

  vec3 toSun0 = vec3(dot(uSun0Direction, tangent), dot(uSun0Direction, bitangent), dot(uSun0Direction, normal));
  float xSun0 = 1.0 - sqrt(0.5 * dot(toCamera, uSun0Direction) + 0.5);
  vToSun0 = vec4(toSun0, xSun0 * xSun0 * xSun0 * xSun0 * xSun0);
  vHalfSun0 = eye + toSun0;
  vHalfSun0.z += 1.0e-4;
}
