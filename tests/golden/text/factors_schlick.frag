#version 100
// FrankenShader
//   suns: sun1
//   brdf: schlick
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
uniform vec3 uLobe; // material: 1 - alpha^2, and the shadowing's coefficients
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi

float root(float x) {
  return sqrt(x);
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
  float smithV = nDotV * surface.smith.x + surface.smith.y;
  float smithL = light.x * surface.smith.x + surface.smith.y;
  float width = light.z - light.y * surface.slope;
  return surface.gain * light.z * light.z * inverse(width * width * smithV * smithL);
}

// light: see lightAngles. radiance: irradiance / pi.
void addLight(vec3 radiance, vec4 light, float nDotV, Surface surface, inout vec3 diffuse, inout vec3 specular) {
  float entering = light.x - light.x * light.w;
  float mirror = lobe(light, nDotV, surface);
  diffuse += radiance * (entering * (surface.metal * mirror + surface.diffuse));
  specular += radiance * (mirror * (light.x - entering * surface.clear));
}

// normal and toCamera times their scale are unit, as toLight is. Returns N.L clamped; (N.(V+L))^2;
// |V+L|^2, kept off 0; Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, vec3 toCamera, vec2 scale, float nDotV, vec3 toLight) {
  float nDotL = max(scale.x * dot(normal, toLight), 0.0);
  float nDotH = nDotL + nDotV;
  float h2 = (dot(toCamera, toLight) * scale.y) * 2.0 + 2.000002;
  float x = 1.0 - root(0.25 * h2);
  float x2 = x * x;
  return vec4(nDotL, nDotH * nDotH, h2, x2 * x2 * x);
}

// The sRGB transfer curve (IEC 61966-2-1). c: linear light; clipped at 0 and 1. Returns codes, 0-1.
vec3 encodeDisplay(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 high = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(high, 12.92 * c, step(c, vec3(0.0031308)));
}

void main() {
  vec4 base = uBaseColor;
  vec3 normal = vNormal;
  Surface surface = Surface(uReflectance.x, uReflectance.y, uReflectance.w, uLobe.x, uLobe.yz, 1.0);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec2 scale = vec2(inverseRoot(dot(normal, normal)), inverseRoot(dot(vToCamera, vToCamera)));
  float nDotV = max(dot(normal, vToCamera) * (scale.y * scale.x), 1.0e-4);
  vec4 anglesSun0 = lightAngles(normal, vToCamera, scale, nDotV, uSun0Direction);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, diffuse, specular);
  vec3 color = base.rgb * diffuse + specular;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
