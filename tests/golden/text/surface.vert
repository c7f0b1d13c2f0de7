#version 100
// FrankenShader
//   transform/position: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;

uniform mat4 uModelViewProjection; // object: model space to clip space

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);
}
