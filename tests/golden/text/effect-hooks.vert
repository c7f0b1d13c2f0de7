#version 100
// FrankenShader
//   transform/moved: 1
//   transform/effect: 1
//   transform/position.moved: 1
//   frame/normal: 1
//   frame/normal_varying: 1
//   frame/to_camera.moved: 1
//   frame/to_camera_varying: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
attribute vec3 aNormal;

varying float vHeight;
varying vec3 vNormal;
varying vec3 vToCamera;

uniform vec3 uCameraPosition; // frame: world space
uniform mat4 uModelViewProjection; // object: model space to clip space
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
uniform mat4 uModel; // object: model space to world space
uniform vec4 uWave; // user: amplitude, m; three more

vec3 onVertex(vec3 position) {
  vHeight = position.y;
  return position + uWave.xyz;
}

void main() {
  vec3 position = aPosition;
  position = onVertex(position);
  gl_Position = uModelViewProjection * vec4(position, 1.0);

  vec3 normal = normalize(uNormalMatrix * aNormal);
  vNormal = normal;
  vec3 toCamera = uCameraPosition - (uModel * vec4(position, 1.0)).xyz;
  vToCamera = toCamera;
}
