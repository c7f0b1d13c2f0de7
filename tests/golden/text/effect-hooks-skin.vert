#version 100
// FrankenShader
//   skin/palette.32: 1
//   skin/matrix: 1
//   skin/influence: 2
//   transform/moved.skin: 1
//   transform/effect: 1
//   transform/position.moved: 1
//   frame/normal.skin: 1
//   frame/normal_varying: 1
//   frame/to_camera.moved: 1
//   frame/to_camera_varying: 1
//
// VERTEX SHADER
//
attribute vec4 aJoints; // where each joint's rows begin in uJoints
attribute vec4 aWeights; // add up to 1
attribute vec3 aPosition;
attribute vec3 aNormal;

varying float vHeight;
varying vec3 vNormal;
varying vec3 vToCamera;

uniform vec3 uCameraPosition; // frame: world space
uniform mat4 uModelViewProjection; // object: model space to clip space
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
uniform mat4 uModel; // object: model space to world space
uniform vec4 uJoints[96]; // skin: three rows of a matrix for each joint, from the bind pose to model space
uniform vec4 uWave; // user: amplitude, m; three more

vec3 onVertex(vec3 position) {
  vHeight = position.y;
  return position + uWave.xyz;
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

  vec4 boundPosition = vec4(aPosition, 1.0);
  vec3 position = vec3(dot(skinX, boundPosition), dot(skinY, boundPosition), dot(skinZ, boundPosition));
  position = onVertex(position);
  gl_Position = uModelViewProjection * vec4(position, 1.0);

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
