#version 100
// FrankenShader
//   transform/skybox: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition; // clip space: (-1,-1), (3,-1), (-1,3)

varying vec3 vDirection;

uniform mat3 uClipToSky; // frame: (x, y, 1) in clip space to a direction in the sky

void main() {
  vDirection = uClipToSky * vec3(aPosition.xy, 1.0);
  gl_Position = vec4(aPosition.xy, 1.0, 1.0);
}
