#version 100
// FrankenShader
//   ambient: sh
//   skySpecular: 1
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
uniform vec4 uReflectance; // material: scattered, metalness, 0.04 (1 - metalness), scattered times base
uniform vec3 uSky[9]; // lights: linear; order 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2
uniform sampler2D uSpecularSky; // frame: RGBM, square-rooted
uniform float uSpecularRange; // frame: the largest radiance that a texel can hold, times the exposure
uniform vec3 uSpecularLobe; // material: roughness; the level over N.V, and at 0
uniform sampler2D uSpecularLookup; // frame: u is N.V, v roughness; F0's factor, the rest, bend, irradiance's share

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return 1.0 / x;
}

// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  return uSky[0] + uSky[1] * n.y + uSky[2] * n.z + uSky[3] * n.x
       + uSky[4] * (n.x * n.y) + uSky[5] * (n.y * n.z) + uSky[6] * (3.0 * n.z * n.z - 1.0)
       + uSky[7] * (n.x * n.z) + uSky[8] * (n.x * n.x - n.y * n.y);
}

// d: of any length. Returns where it lies in the first level, less the point that the levels shrink towards.
vec2 skyPoint(vec3 d) {
  vec3 a = abs(d);
  vec2 p = d.xz * inverse(max(a.x, a.z) + a.y);
  return vec2(p.x * 0.21875 + (d.y < 0.0 ? 0.75 : 0.25), p.y * 0.1340657 - 0.8930197);
}

// level: 0-8, of the roughness 2^((level - 8) / 2). Returns radiance over uSpecularRange.
vec3 skyThroughLobe(vec3 d, float level) {
  float blend = fract(level);
  float size = exp2(-0.5 * floor(level));
  vec2 point = skyPoint(d);
  vec4 sharp = texture2D(uSpecularSky, point * size + vec2(0.0, 1.0462376));
  vec4 rough = texture2D(uSpecularSky, point * (0.70710678 * size) + vec2(0.0, 1.0462376));
  vec3 root = sharp.rgb * (sharp.a - sharp.a * blend) + rough.rgb * (rough.a * blend);
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
  vec3 diffuse = max(skyLight(normal), 0.0);
  vec3 irradiance = diffuse;
  diffuse *= uReflectance.x;
  vec3 specular = vec3(0.0);
  vec3 toCamera = vToCamera * inverseRoot(dot(vToCamera, vToCamera));
  float nDotV = max(dot(normal, toCamera), 1.0e-4);
  vec4 look = texture2D(uSpecularLookup, vec2(nDotV, uSpecularLobe.x));
  vec3 toSky = normal * ((2.0 * nDotV - 1.0) * look.b + 1.0) - toCamera * look.b;
  float level = max(nDotV * uSpecularLobe.y + uSpecularLobe.z, 0.0);
  vec3 mirrored = mix(skyThroughLobe(toSky, level) * uSpecularRange, irradiance, look.a);
  diffuse += mirrored * (look.r * uReflectance.y);
  specular += mirrored * (look.r * uReflectance.z + look.g);
  vec3 color = base.rgb * diffuse + specular;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
