#version 100
// FrankenShader overlay+basecolor.blend
//   program: overlay
//   baseColorTexture: 1
//   alpha: blend
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;

uniform vec4 uBaseColor; // material: linear RGB and alpha

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base *= uBaseColor;

  vec3 color = base.rgb;

  gl_FragColor = vec4(color, base.a);
}
