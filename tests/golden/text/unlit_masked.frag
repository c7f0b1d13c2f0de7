#version 100
// FrankenShader basecolor.vertexcolor.mask.basecolor-uv1.unlit+pow22
//   baseColorTexture: 1
//   vertexColor: 1
//   alpha: mask
//   baseColorUv: 1
//   shading: 1
//   output: pow22
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv1;
varying vec4 vColor;

uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform float uAlphaCutoff; // material: 0-1

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

// c: linear light, 0 and up. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  return pow(c, vec3(1.0 / 2.2));
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv1);
  base.rgb = srgbToLinear(base.rgb);
  base *= uBaseColor;
  base *= vColor;
  if (base.a < uAlphaCutoff) discard;

  vec3 color = base.rgb;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
