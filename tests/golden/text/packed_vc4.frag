#version 100
// FrankenShader
//   baseColorTexture: 1
//   metallicRoughness: metalrough
//   suns: sun1
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
uniform vec4 uBaseColor; // material: linear RGB and alpha
uniform sampler2D uMetallicRoughnessTexture; // material: linear
uniform vec2 uMetallicRoughness; // material: factors, 0-1
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform vec3 uSun0Radiance; // lights: linear irradiance / pi

// The inverse of the sRGB transfer curve (IEC 61966-2-1). c: codes, 0-1. Returns linear light, 0-1.
vec3 decodeSrgb(vec3 c) {
  vec3 low = c * (1.0 / 12.92);
  vec3 high = pow(c * (1.0 / 1.055) + 0.055 / 1.055, vec3(2.4));
  return mix(high, low, step(c, vec3(0.04045)));
}

float root(float x) {
  return exp2(0.50001 * log2(x));
}

float inverseRoot(float x) {
  return exp2(-0.50001 * log2(x));
}

float inverse(float x) {
  return exp2(-1.00001 * log2(x));
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

// normal and toCamera times their scale are unit, as toLight is. squares: |normal|^2; 1 + |V|^2, kept off 2.
// facing: N.V of the unscaled normal. Returns N.L clamped; (N.(V+L))^2 and |V+L|^2, both times |normal|^2;
// Schlick's (1 - V.H)^5.
vec4 lightAngles(vec3 normal, vec3 toCamera, vec2 squares, vec2 scale, float facing, vec3 toLight) {
  float facingLight = max(dot(normal, toLight), 0.0);
  float nDotH = facingLight + facing;
  float h2 = (dot(toCamera, toLight) * scale.y) * 2.0 + squares.y;
  float x = 1.0 - root(0.25 * h2);
  float x2 = x * x;
  return vec4(facingLight * scale.x, nDotH * nDotH, squares.x * h2, x2 * x2 * x);
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
  vec3 normal = vNormal;
  vec3 orm = texture2D(uMetallicRoughnessTexture, vUv0).rgb;
  float metallic = orm.b * uMetallicRoughness.x;
  float roughness = orm.g * uMetallicRoughness.y;
  Surface surface = makeSurface(metallic, roughness);
  vec3 diffuse = vec3(0.0);
  vec3 specular = vec3(0.0);
  vec2 squares = vec2(dot(normal, normal), dot(vToCamera, vToCamera));
  vec2 scale = vec2(inverseRoot(squares.x), inverseRoot(squares.y));
  squares.y = squares.y * (scale.y * scale.y) + 1.000002;
  float facing = max(dot(normal, vToCamera) * scale.y, 5.0e-5);
  float nDotV = facing * scale.x;
  vec4 anglesSun0 = lightAngles(normal, vToCamera, squares, scale, facing, uSun0Direction);
  addLight(uSun0Radiance, anglesSun0, nDotV, surface, diffuse, specular);
  vec3 color = base.rgb * diffuse + specular;
  color = encodeDisplay(color);
  gl_FragColor = vec4(color, 1.0);
}
