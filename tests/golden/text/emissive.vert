#version 100
// FrankenShader
//   position: 1
//   uv1_transform: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
uniform mat4 uModelViewProjection; // object: model space to clip space
attribute vec2 aUv1;
uniform mat3 uUv1Transform; // material: KHR_texture_transform
varying vec2 vUv1;

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);
  vUv1 = (uUv1Transform * vec3(aUv1, 1.0)).xy;
}
