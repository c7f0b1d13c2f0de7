#version 100
// FrankenShader
//   position: 1
//   uv0: 1
//   normal: 1
//   normal_varying: 1
//   world: 1
//   camera_varying: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
uniform mat4 uModelViewProjection; // object: model space to clip space
attribute vec2 aUv0;
varying vec2 vUv0;
attribute vec3 aNormal;
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
varying vec3 vNormal;
uniform mat4 uModel; // object: model space to world space
uniform vec3 uCameraPosition; // frame: world space
varying vec3 vToCamera;

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);
  vUv0 = aUv0;
  vec3 normal = normalize(uNormalMatrix * aNormal);
  vNormal = normal;
  vec3 toCamera = uCameraPosition - (uModel * vec4(aPosition, 1.0)).xyz;
  vToCamera = toCamera;
}
