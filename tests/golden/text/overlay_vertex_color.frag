#version 100
// FrankenShader overlay+vertexcolor
//   program: overlay
//   vertexColor: 1
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec4 vColor;

uniform vec4 uBaseColor; // material: linear RGB and alpha

void main() {
  vec4 base = uBaseColor;
  base *= vColor;

  vec3 color = base.rgb;

  gl_FragColor = vec4(color, 1.0);
}
