#version 100
// FrankenShader overlay+basecolor+linear
//   program: overlay
//   baseColorTexture: 1
//   output: linear
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

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = srgbToLinear(base.rgb);
  base *= uBaseColor;

  vec3 color = base.rgb;

  gl_FragColor = vec4(color, 1.0);
}
