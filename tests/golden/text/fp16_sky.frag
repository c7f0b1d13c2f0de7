#version 100
// FrankenShader sky+fp16
//   program: sky
//   precision: 1
//
// FRAGMENT SHADER
//
precision mediump float;

varying vec3 vDirection;

uniform float uSkyRange; // frame: the largest radiance that a texel can hold, times the exposure

uniform samplerCube uSkyTexture; // frame: RGBM, square-rooted

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 texel = textureCube(uSkyTexture, vDirection);
  vec3 color = texel.rgb * (texel.a * sqrt(uSkyRange));
  color *= color;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
