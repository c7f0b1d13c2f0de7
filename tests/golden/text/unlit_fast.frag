#version 100
// FrankenShader basecolor.unlit+srgb-fast
//   baseColorTexture: 1
//   shading: 1
//   output: srgb-fast
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;

uniform vec3 uBaseColorEncoded[2]; // material: k, and 0.055 (k - 1)

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = base.rgb * uBaseColorEncoded[0] + uBaseColorEncoded[1];

  vec3 color = base.rgb;

  gl_FragColor = vec4(color, 1.0);
}
