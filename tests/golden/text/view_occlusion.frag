#version 100
// FrankenShader occlusion+dither+view-occlusion
//   occlusion: occlusion
//   dither: 1
//   view: view-occlusion
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;

uniform vec3 uDither; // frame: amplitude per channel, in output units: 1/255 for 8 bits, 1/31 for 5
uniform vec2 uOcclusion; // material: strength, 1 - strength

uniform sampler2D uOcclusionTexture; // material: R, linear

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
  float occlusion = texture2D(uOcclusionTexture, vUv0).r * uOcclusion.x + uOcclusion.y;

  vec3 color = vec3(occlusion);

  color += bayer4(floor(gl_FragCoord.xy)) * uDither;
  gl_FragColor = vec4(color, 1.0);
}
