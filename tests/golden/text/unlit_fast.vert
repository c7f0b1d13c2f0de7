#version 100
// FrankenShader
//   transform/position: 1
//   streams/uv0: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
attribute vec2 aUv0;

varying vec2 vUv0;

uniform mat4 uModelViewProjection; // object: model space to clip space

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);

  vUv0 = aUv0;
}
