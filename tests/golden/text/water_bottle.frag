#version 100
// FrankenShader
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   normal: 1
//   occlusion: occlusion-packed
//   emissive: emissive
//   ambient: ambient
//   suns: sun1
//   punctualLights: punctual1
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
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear
varying vec3 vTangent;
varying vec3 vBitangent;
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform vec2 uOcclusion; // material: strength, 1 - strength
uniform vec3 uAmbient; // lights: linear radiance
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi
uniform vec4 uPunctual0Position; // lights: from the eye, world space, m; 1 / range^2
uniform vec3 uPunctual0Radiance; // lights: linear intensity / pi
uniform vec3 uEmissive; // material: linear radiance where the texture is white
uniform sampler2D uEmissiveTexture; // material: RGB as `decode` says

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

// metallic, roughness: 0-1. The roughness is kept off 0, where a sun's mirror image has no size.
Surface makeSurface(float metallic, float roughness) {
  float r = max(roughness, 0.001);
  float alpha2 = (r * (r * r)) * r;
  float slope = 1.0 - alpha2;
  return Surface(0.96 - 0.96 * metallic, metallic, 0.96 + 0.04 * metallic, slope, vec2(slope, alpha2), 0.5 * alpha2);
}

// All vectors unit. Returns N.L clamped; (N.(V+L))^2; |V+L|^2, kept off 0; Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, float nDotV, vec3 toCamera, vec3 toLight) {
  float nDotL = max(dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  float h2 = 2.0 * dot(toCamera, toLight) + 2.000002;
  float x = 1.0 - root(0.25 * h2);
  float x2 = x * x;
  return vec4(nDotL, nDotH * nDotH, h2, x2 * x2 * x);
}

// Inverse square with a window at the range (KHR_lights_punctual, "Range Property"). distance2 in m^2;
// inverseRange2 = 1 / range^2, 0 where the range is infinite.
float distanceAttenuation(float distance2, float inverseRange2) {
  float d = distance2 * inverseRange2;
  return clamp(1.0 - d * d, 0.0, 1.0) / max(distance2, 1.0e-8);
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
  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;
  float occlusion = orm.r * uOcclusion.x + uOcclusion.y;
  Surface surface = makeSurface(metallic, roughness);
  vec3 diffuse = uAmbient;
  diffuse *= occlusion;
  vec3 specular = vec3(0.0);
  vec3 toCamera = vToCamera * inverseRoot(dot(vToCamera, vToCamera));
  float nDotV = max(dot(normal, toCamera), 1.0e-4);
  vec4 anglesSun0 = lightAngles(normal, nDotV, toCamera, uSun0Direction);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, diffuse, specular);
  vec3 toPunctual0 = uPunctual0Position.xyz + vToCamera;
  float distancePunctual0 = dot(toPunctual0, toPunctual0);
  toPunctual0 *= inverseRoot(max(distancePunctual0, 1.0e-8));
  vec3 radiancePunctual0 = uPunctual0Radiance * distanceAttenuation(distancePunctual0, uPunctual0Position.w);
  vec4 anglesPunctual0 = lightAngles(normal, nDotV, toCamera, toPunctual0);
  addLight(radiancePunctual0, anglesPunctual0, nDotV, surface, diffuse, specular);
  vec3 color = base.rgb * diffuse + specular;
  color += uEmissive * decodeSrgb(texture2D(uEmissiveTexture, vUv0).rgb);
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
