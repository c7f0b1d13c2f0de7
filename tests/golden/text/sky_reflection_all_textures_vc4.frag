#version 100
// FrankenShader
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   normal: 1
//   occlusion: occlusion-packed
//   emissive: emissive
//   ambient: sh
//   reflection: 1
//   suns: sun2
//   decode: decode-fast
//   output: srgb-fast
//   target: 1
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
varying vec3 vToCamera;
uniform sampler2D uBaseColorTexture; // material: RGB as `decode` says, alpha
uniform vec3 uBaseColorCubic[3]; // material: coefficients of c^3, c^2 and c, times the factor
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
varying vec3 vTangent;
varying vec3 vBitangent;
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform sampler2D uReflectionTexture; // frame: RGBM, square-rooted
uniform float uReflectionScale; // frame: root of the largest radiance that a texel can hold, times the exposure
uniform sampler2D uReflectionLookup; // frame: u is N.V, v roughness; F0's factor, the rest, level / 8, irradiance's share
uniform vec2 uOcclusion; // material: strength, 1 - strength
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec3 uSun1Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi
uniform vec3 uEmissiveCubic[3]; // material: coefficients of c^3, c^2 and c, times the radiance of white
uniform sampler2D uEmissiveTexture; // material: RGB as `decode` says

float root(float x) {
  return exp2(0.50001 * log2(x));
}

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return exp2(-1.00001 * log2(x));
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
  float smithL = nDotV * root(light.x * (light.x * surface.smith.x) + surface.smith.y);
  float smithV = light.x * root(nDotV * (surface.smith.x * nDotV) + surface.smith.y);
  float width = light.z - light.y * surface.slope;
  float h = log2(light.z);
  return surface.gain * exp2((h + h) - log2((smithV + smithL) * (width * width)));
}

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, vec3 base, inout vec3 color) {
  float mirror = lobe(light, nDotV, surface);
  float entering = light.x - light.x * light.w;
  float tinted = (surface.diffuse + surface.metal * mirror) * entering;
  color += radiance * (mirror * (light.x - entering * surface.clear) + base * tinted);
}

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's mirror image has no size.
Surface makeSurface(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * (r * r)) * r;
  float slope = 1.0 - alpha2;
  return Surface(0.96 - 0.96 * metallic, metallic, 0.96 + 0.04 * metallic, slope, vec2(slope, alpha2), 0.5 * alpha2);
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

// All vectors unit. Returns N.L clamped; (N.(V+L))^2; |V+L|^2, kept off 0; Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, float nDotV, vec3 toCamera, vec3 toLight) {
  float nDotL = max(dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  float vDotL = dot(toCamera, toLight) + 1.000001;
  float h2 = vDotL + vDotL;
  float x = 1.0 - exp2(0.50001 * log2(h2) - 1.0);
  float x2 = x * x;
  return vec4(nDotL, nDotH * nDotH, h2, x2 * x2 * x);
}

// The power part of the sRGB curve alone: below code 10 it is too dark. c: linear light, 0 and up.
vec3 encodeDisplay(vec3 c) {
  return exp2(log2(c) * (1.0 / 2.4) + 0.07724300) - 0.055;
}

void main() {
  vec4 base = texture2D(uBaseColorTexture, vUv0);
  base.rgb = base.rgb * (base.rgb * (base.rgb * uBaseColorCubic[0] + uBaseColorCubic[1]) + uBaseColorCubic[2]);
  vec3 normal = mapNormal(texture2D(uNormalTexture, vUv0).xyz, vTangent, vBitangent, vNormal);
  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;
  vec3 irradiance = skyLight(normal);
  Surface surface = makeSurface(metallic, roughness);
  vec3 toCamera = vToCamera * inverseRoot(dot(vToCamera, vToCamera));
  float nDotV = max(dot(normal, toCamera), 1.0e-4);
  float alpha = roughness * roughness;
  float bend = alpha * (0.6 + metallic);
  vec3 toSky = mix(bend, 2.0, nDotV) * normal - toCamera;
  vec4 look = texture2D(uReflectionLookup, vec2(nDotV, roughness));
  vec3 mirrored = mix(skyThroughLobe(toSky, 8.0 * look.b), irradiance, look.a);
  vec3 skyShare = vec3(0.96 - 0.96 * metallic, metallic * look.r, look.g + look.r * (0.04 - metallic * 0.04));
  float occlusion = orm.r * uOcclusion.x + uOcclusion.y;
  skyShare *= occlusion;
  vec3 color = mirrored * (skyShare.y * base.rgb + skyShare.z) + (irradiance * skyShare.x) * base.rgb;
  vec4 anglesSun0 = lightAngles(normal, nDotV, toCamera, uSun0Direction);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, base.rgb, color);
  vec4 anglesSun1 = lightAngles(normal, nDotV, toCamera, uSun1Direction);
  addLight(uSun1Radiance, anglesSun1, nDotV, surface, base.rgb, color);
  vec3 glow = texture2D(uEmissiveTexture, vUv0).rgb;
  color += glow * (glow * (glow * uEmissiveCubic[0] + uEmissiveCubic[1]) + uEmissiveCubic[2]);
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
