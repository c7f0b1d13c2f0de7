#version 100
// FrankenShader
//   skin/palette.32: 1
//   skin/matrix.rigid: 1
//   transform/moved.skin: 1
//   transform/position.moved: 1
//   streams/uv0: 1
//   frame/normal.skin: 1
//   frame/normal_varying: 1
//   frame/to_camera.moved: 1
//   frame/to_camera_varying: 1
//
// VERTEX SHADER
//
attribute vec4 aJoints; // x: where the joint's rows begin in uJoints
attribute vec3 aPosition;
attribute vec2 aUv0;
attribute vec3 aNormal;

varying vec2 vUv0;
varying vec3 vNormal;
varying vec3 vToCamera;

uniform vec3 uCameraPosition; // frame: world space
uniform mat4 uModelViewProjection; // object: model space to clip space
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
uniform mat4 uModel; // object: model space to world space
uniform vec4 uJoints[96]; // skin: three rows of a matrix for each joint, from the bind pose to model space

void main() {
  int skinJoint = int(aJoints.x);
  vec4 skinX = uJoints[skinJoint];
  vec4 skinY = uJoints[skinJoint + 1];
  vec4 skinZ = uJoints[skinJoint + 2];

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
  vNormal = normal;
  vec3 toCamera = uCameraPosition - (uModel * vec4(position, 1.0)).xyz;
  vToCamera = toCamera;
}
