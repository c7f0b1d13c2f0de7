#version 100
// FrankenShader unlit+rim@d367eeed
//   shading: 1
//   effect: rim
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec3 vNormal;
varying vec3 vToCamera;

uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec4 uRim; // user: linear colour, in the units of exposed light; exponent, 1 and up: the higher, the thinner

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

vec3 onLight(vec3 color, vec3 normal, vec3 toEye) {
  float facing = max(dot(normal, toEye) * inversesqrt(dot(toEye, toEye)), 0.0);
  return color + uRim.rgb * pow(1.0 - facing, uRim.w);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 linearToDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = uBaseColor;

  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));

  vec3 toEye = vToCamera;

  vec3 color = base.rgb;

  color = onLight(color, normal, toEye);

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
