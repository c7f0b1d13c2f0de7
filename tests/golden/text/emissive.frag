#version 100
// FrankenShader emissive.emissive-uv1+reinhard
//   emissive: emissive
//   emissiveUv: 1
//   toneMap: reinhard
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv1;

uniform vec3 uEmissive; // material: linear radiance where the texture is white

uniform sampler2D uEmissiveTexture; // material: RGB, sRGB unless decode-none

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

// c: linear radiance, 0 and up. Returns 0-1.
vec3 toneMap(vec3 c) {
  return c / (c + 1.0);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec3 color = vec3(0.0);

  color += uEmissive * srgbToLinear(texture2D(uEmissiveTexture, vUv1).rgb);

  color = toneMap(color);
  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
