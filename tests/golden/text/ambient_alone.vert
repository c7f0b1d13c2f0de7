#version 100
// FrankenShader
//   position: 1
//   uv0: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
uniform mat4 uModelViewProjection; // object: model space to clip space
attribute vec2 aUv0;
varying vec2 vUv0;

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);
  vUv0 = aUv0;
}
