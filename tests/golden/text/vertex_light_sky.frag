#version 100
// FrankenShader
//   baseColorTexture: 1
//   normal: 1
//   ambient: sh
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
uniform vec4 uReflectance; // material: scattered, metalness, 0.04 (1 - metalness), kept (seed) or 1 - the third
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
uniform vec3 uSky[9]; // lights: linear; order 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2
varying vec3 vToCamera;
varying vec4 vVDotL;
varying vec4 vFresnel;
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
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float entering = light.x - light.x * light.w;
  float mirror = lobe(light, nDotV, surface);
  diffuse += radiance * (entering * (surface.metal * mirror + surface.diffuse));
  specular += radiance * (mirror * (light.x - entering * surface.clear));
}

// n: unit, world space. Returns linear radiance of a white surface.
vec3 skyLight(vec3 n) {
  return uSky[0] + uSky[1] * n.y + uSky[2] * n.z + uSky[3] * n.x
       + uSky[4] * (n.x * n.y) + uSky[5] * (n.y * n.z) + uSky[6] * (3.0 * n.z * n.z - 1.0)
       + uSky[7] * (n.x * n.z) + uSky[8] * (n.x * n.x - n.y * n.y);
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
  Surface surface = Surface(uReflectance.x, uReflectance.y, uReflectance.w, uLobe.x, uLobe.yz, 1.0);
  vec3 diffuse = max(skyLight(normal), 0.0);
  diffuse *= uReflectance.x;
  vec3 specular = vec3(0.0);
  float reach = dot(vToCamera, vToCamera) + 1.000002;
  float nDotV = max(dot(normal, vToCamera), 1.0e-4);
  vec4 anglesSun0 = lightAngles(normal, nDotV, reach, uSun0Direction, vVDotL.x, vFresnel.x);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, diffuse, specular);
  vec4 anglesSun1 = lightAngles(normal, nDotV, reach, uSun1Direction, vVDotL.y, vFresnel.y);
  addLight(uSun1Radiance, anglesSun1, nDotV, surface, diffuse, specular);
  vec3 color = base.rgb * diffuse + specular;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
