#version 100
// FrankenShader sky+aces+srgb-fast+dither
//   program: sky
//   toneMap: aces
//   output: srgb-fast
//   dither: 1
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec3 vDirection;

uniform float uSkyRange; // frame: the largest radiance that a texel can hold, times the exposure
uniform vec3 uDither; // frame: amplitude per channel, in output units: 1/255 for 8 bits, 1/31 for 5

uniform samplerCube uSkyTexture; // frame: RGBM, square-rooted

// c: linear radiance, 0 and up. Returns 0-1, and slightly above for the brightest.
vec3 toneMap(vec3 c) {
  return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
}

// The power part of the sRGB curve alone: below code 10 it is too dark. c: linear light, 0 and up.
vec3 linearToDisplay(vec3 c) {
  return 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
}

// The 2x2 matrix 0 2 / 3 1, over 4. p: whole pixels.
float bayer2(vec2 p) {
  p = mod(p, 2.0);
  return fract(0.5 * p.x + 0.75 * p.y);
}

// The 4x4 matrix from two 2x2 ones, centred: -15/32 to +15/32.
float bayer4(vec2 p) {
  return bayer2(floor(0.5 * p)) * 0.25 + bayer2(p) - 0.46875;
}

void main() {
  vec4 texel = textureCube(uSkyTexture, vDirection);
  vec3 color = texel.rgb * texel.a;
  color *= color * uSkyRange;

  color = toneMap(color);
  color = linearToDisplay(color);
  color += bayer4(floor(gl_FragCoord.xy)) * uDither;
  gl_FragColor = vec4(color, 1.0);
}
