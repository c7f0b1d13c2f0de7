#version 100
// FrankenShader
//   baseColorTexture: 1
//   normal: 1
//   occlusion: occlusion
//   ambient: sh
//   reflection: 1
//   suns: sun2
//   lightVectors: 1
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
uniform sampler2D uBaseColorTexture; // material: RGB as `decode` says, alpha
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
varying vec3 vTangent;
varying vec3 vBitangent;
uniform sampler2D uOcclusionTexture; // material: R, linear
uniform vec2 uOcclusion; // material: strength, 1 - strength
uniform vec4 uReflectance; // material: scattered, metalness, 0.04 (1 - metalness), kept (seed) or 1 - the third
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;
uniform vec3 uReflectionLobe; // material: roughness; the bend, and 2 less that
uniform sampler2D uReflectionLookup; // frame: u is N.V, v roughness; F0's factor, the rest, level / 8, irradiance's share
uniform mediump vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform mediump vec3 uSun1Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 decodeSrgb(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float root(float x) {
  return sqrt(x);
}

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return 1.0 / x;
}

// texel: as stored. The frame's axes may have any length; x and y carry the map's scale.
vec3 mapNormal(vec3 texel, vec3 tangent, vec3 bitangent, vec3 normal) {
  vec3 n = texel - 0.5;
  n = n.x * tangent + normal * n.z + n.y * bitangent;
  return n * inverseRoot(dot(n, n));
}

// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  float reach = 0.0546875 - 0.02734375 * abs(n.y);
  vec2 point = vec2(n.x * reach + (n.y < 0.0 ? 0.9375 : 0.8125), n.z * reach + 0.75);
  vec4 texel = texture2D(uReflectionTexture, point);
  vec3 root = texel.rgb * (texel.a * uReflectionScale);
  return root * root;
}

struct Surface {
  float diffuse; // 0.96 (1 - metalness): what a dielectric lets in and scatters
  float metal; // metalness
  float clear; // 1 - 0.04 (1 - metalness): what is not mirrored without a tint
  float slope; // 1 - alpha^2
  vec2 smith; // coefficients of the shadowing, by BRDF
  float gain; // what the shadowing's coefficients do not hold
};

// pi D V. light: see lightAngles.
float lobe(vec4 light, float nDotV, Surface surface) {
  float width = light.z - light.y * surface.slope;
  float smithL = nDotV * root(light.x * (light.x * surface.smith.x) + surface.smith.y);
  float smithV = light.x * root(nDotV * (surface.smith.x * nDotV) + surface.smith.y);
  return (light.z * light.z) * surface.gain * inverse((smithV + smithL) * (width * width));
}

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, vec3 base, inout vec3 color) {
  float mirror = lobe(light, nDotV, surface);
  float entering = light.x - light.x * light.w;
  float tinted = (surface.diffuse + surface.metal * mirror) * entering;
  color += radiance * (mirror * (light.x - entering * surface.clear) + base * tinted);
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

// lightAngles of a light whose V.L and Fresnel term are given. reach: 1 + |V|^2, as V shrinks between vertices.
vec4 lightAngles(vec3 normal, float nDotV, float reach, vec3 toLight, float vDotL, float fresnel) {
  float nDotL = max(dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  return vec4(nDotL, nDotH * nDotH, 2.0 * vDotL + reach, fresnel);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 encodeDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = decodeSrgb(base.rgb);
  base *= uBaseColor;
  vec3 normal = mapNormal(texture2D(uNormalTexture, vUv0).xyz, vTangent, vBitangent, vNormal);
  float occlusion = texture2D(uOcclusionTexture, vUv0).r * uOcclusion.x + uOcclusion.y;
  vec3 irradiance = skyLight(normal);
  Surface surface = Surface(uReflectance.x, uReflectance.y, uReflectance.w, uLobe.x, uLobe.yz, 1.0);
  float reach = dot(vToCamera, vToCamera) + 1.000002;
  float nDotV = max(dot(normal, vToCamera), 1.0e-4);
  vec3 toCamera = vToCamera;
  vec4 look = texture2D(uReflectionLookup, vec2(nDotV, uReflectionLobe.x));
  vec3 toSky = normal * (uReflectionLobe.z * nDotV + uReflectionLobe.y) - toCamera;
  vec3 mirrored = mix(skyThroughLobe(toSky, 8.0 * look.b), irradiance, look.a);
  vec3 skyShare = vec3(uReflectance.x, look.r * uReflectance.y, look.r * uReflectance.z + look.g);
  skyShare *= occlusion;
  vec3 color = mirrored * (skyShare.y * base.rgb + skyShare.z) + (irradiance * skyShare.x) * base.rgb;
  vec4 anglesSun0 = lightAngles(normal, nDotV, reach, uSun0Direction, vVDotL.x, vFresnel.x);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, base.rgb, color);
  vec4 anglesSun1 = lightAngles(normal, nDotV, reach, uSun1Direction, vVDotL.y, vFresnel.y);
  addLight(uSun1Radiance, anglesSun1, nDotV, surface, base.rgb, color);
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
