#version 100
// FrankenShader
//   transform/position: 1
//   streams/uv1.transform: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
attribute vec2 aUv1;

varying vec2 vUv1;

uniform mat3 uUv1Transform; // material: KHR_texture_transform
uniform mat4 uModelViewProjection; // object: model space to clip space

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);

  vUv1 = (uUv1Transform * vec3(aUv1, 1.0)).xy;
}
