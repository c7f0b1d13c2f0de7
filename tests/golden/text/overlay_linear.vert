#version 100
// FrankenShader
//   transform/overlay: 1
//   streams/uv0: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition; // z is not used
attribute vec2 aUv0;

varying vec2 vUv0;

uniform mat3 uOverlay; // object: (x, y, 1) in the overlay's units to clip space

void main() {
  gl_Position = vec4((uOverlay * vec3(aPosition.xy, 1.0)).xy, 0.0, 1.0);

  vUv0 = aUv0;
}
