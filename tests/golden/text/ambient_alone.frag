#version 100
// FrankenShader basecolor.occlusion+ambient+aces
//   baseColorTexture: 1
//   occlusion: occlusion
//   ambient: ambient
//   toneMap: aces
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;

uniform vec3 uAmbient; // lights: linear radiance
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec2 uOcclusion; // material: strength, 1 - strength

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha
uniform sampler2D uOcclusionTexture; // material: R, linear

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

// c: linear radiance, 0 and up. Returns 0-1, and slightly above for the brightest.
vec3 toneMap(vec3 c) {
  return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = srgbToLinear(base.rgb);
  base *= uBaseColor;

  float occlusion = texture2D(uOcclusionTexture, vUv0).r * uOcclusion.x + uOcclusion.y;

  vec3 irradiance = uAmbient;

  irradiance *= occlusion;

  vec3 color = base.rgb * irradiance;

  color = toneMap(color);
  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
