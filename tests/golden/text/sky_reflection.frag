#version 100
// FrankenShader
//   ambient: sh
//   reflection: 1
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
uniform vec4 uReflectance; // material: scattered, metalness, 0.04 (1 - metalness), kept (seed) or 1 - the third
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that
uniform sampler2D uReflectionLookup; // frame: u is N.V, v roughness; F0's factor, the rest, level / 8, irradiance's share

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return 1.0 / x;
}

// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  float reach = 0.0546875 - 0.02734375 * abs(n.y);
  vec2 point = vec2(n.x * reach + (n.y < 0.0 ? 0.9375 : 0.8125), n.z * reach + 0.75);
  vec4 texel = texture2D(uReflectionTexture, point);
  vec3 root = texel.rgb * (texel.a * uReflectionScale);
  return root * root;
}

// d: of any length. Returns where it lies in the first level, less the point that the levels shrink towards.
vec2 skyPoint(vec3 d) {
  vec3 a = abs(d);
  vec2 p = d.xz * inverse(max(a.x, a.z) + a.y);
  return vec2(p.x * 0.21875 + (d.y < 0.0 ? 0.75 : 0.25), p.y * 0.1340657 - 0.8930197);
}

// level: 0-8, of the roughness 2^((level - 8) / 2). Returns linear radiance.
vec3 skyThroughLobe(vec3 d, float level) {
  float whole = float(int(level));
  float size = exp2(-0.5 * whole);
  vec2 point = size * skyPoint(d);
  vec4 sharp = texture2D(uReflectionTexture, vec2(0.0, 1.0462376) + point);
  vec4 rough = texture2D(uReflectionTexture, vec2(0.0, 1.0462376) + 0.70710678 * point);
  float blend = uReflectionScale * (level - whole);
  vec3 root = rough.rgb * (rough.a * blend) + (sharp.a * (uReflectionScale - blend)) * sharp.rgb;
  return root * root;
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 encodeDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = uBaseColor;
  vec3 normal = vNormal * inverseRoot(dot(vNormal, vNormal));
  vec3 irradiance = skyLight(normal);
  vec3 toCamera = vToCamera * inverseRoot(dot(vToCamera, vToCamera));
  float nDotV = max(dot(normal, toCamera), 1.0e-4);
  vec4 look = texture2D(uReflectionLookup, vec2(nDotV, uReflectionLobe.x));
  vec3 toSky = normal * (uReflectionLobe.z * nDotV + uReflectionLobe.y) - toCamera;
  vec3 mirrored = mix(skyThroughLobe(toSky, 8.0 * look.b), irradiance, look.a);
  vec3 skyShare = vec3(uReflectance.x, look.r * uReflectance.y, look.r * uReflectance.z + look.g);
  vec3 color = mirrored * (skyShare.y * base.rgb + skyShare.z) + (irradiance * skyShare.x) * base.rgb;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
