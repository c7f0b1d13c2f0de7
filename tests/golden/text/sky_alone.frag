#version 100
// FrankenShader basecolor+sh
//   baseColorTexture: 1
//   ambient: sh
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;
varying vec3 vNormal;

uniform vec3 uSky[9]; // lights: linear; order 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform vec4 uReflectance; // material: 0.96 (1 - metalness), metalness, 0.04 (1 - metalness), 1 - 0.04 (1 - metalness)

uniform sampler2D uBaseColorTexture; // material: RGB, sRGB unless decode-none, alpha

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 srgbToLinear(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

// n: unit, world space. Returns irradiance over pi: the linear radiance of a white surface.
vec3 skyIrradiance(vec3 n) {
  // Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001, equation 13.
  return uSky[0] + uSky[1] * n.y + uSky[2] * n.z + uSky[3] * n.x
       + uSky[4] * (n.x * n.y) + uSky[5] * (n.y * n.z) + uSky[6] * (3.0 * n.z * n.z - 1.0)
       + uSky[7] * (n.x * n.z) + uSky[8] * (n.x * n.x - n.y * n.y);
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

  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));

  vec3 irradiance = max(skyIrradiance(normal), 0.0); // nine coefficients can ring below 0
  irradiance *= uReflectance.x;

  vec3 color = base.rgb * irradiance;

  color = linearToDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
