#version 100
// FrankenShader
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   suns: sun4
//   lightVectors: 1
//   brdf: fast
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
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform vec2 uMetallicRoughness; // material: factors, 0-1
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;
uniform mediump vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform mediump vec3 uSun1Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun1Radiance; // lights: linear irradiance / pi
uniform mediump vec3 uSun2Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun2Radiance; // lights: linear irradiance / pi
uniform mediump vec3 uSun3Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun3Radiance; // lights: linear irradiance / pi

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 decodeSrgb(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float inverseRoot(float x) {
  return inversesqrt(x);
}

float inverse(float x) {
  return 1.0 / x;
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
  float smith = light.x * nDotV * surface.smith.x + (light.x + nDotV) * surface.smith.y;
  float width = light.z - light.y * surface.slope;
  return surface.gain * light.z * light.z * inverse(width * width * smith);
}

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float entering = light.x - light.x * light.w;
  float mirror = lobe(light, nDotV, surface);
  diffuse += radiance * (entering * (surface.metal * mirror + surface.diffuse));
  specular += radiance * (mirror * (light.x - entering * surface.clear));
}

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's mirror image has no size.
Surface makeSurface(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha = r * r;
  float alpha2 = alpha * alpha;
  vec2 smith = vec2(2.0 - 2.0 * alpha, alpha);
  return Surface(0.96 - 0.96 * metallic, metallic, 0.96 + 0.04 * metallic, 1.0 - alpha2, smith, 0.5 * alpha2);
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
  vec3 normal = vNormal * inverseRoot(dot(vNormal, vNormal));
  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;
  Surface surface = makeSurface(metallic, roughness);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  float reach = dot(vToCamera, vToCamera) + 1.000002;
  float nDotV = max(dot(normal, vToCamera), 1.0e-4);
  vec4 anglesSun0 = lightAngles(normal, nDotV, reach, uSun0Direction, vVDotL.x, vFresnel.x);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, diffuse, specular);
  vec4 anglesSun1 = lightAngles(normal, nDotV, reach, uSun1Direction, vVDotL.y, vFresnel.y);
  addLight(uSun1Radiance, anglesSun1, nDotV, surface, diffuse, specular);
  vec4 anglesSun2 = lightAngles(normal, nDotV, reach, uSun2Direction, vVDotL.z, vFresnel.z);
  addLight(uSun2Radiance, anglesSun2, nDotV, surface, diffuse, specular);
  vec4 anglesSun3 = lightAngles(normal, nDotV, reach, uSun3Direction, vVDotL.w, vFresnel.w);
  addLight(uSun3Radiance, anglesSun3, nDotV, surface, diffuse, specular);
  vec3 color = base.rgb * diffuse + specular;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
