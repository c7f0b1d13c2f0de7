// SPDX-License-Identifier: MIT
// The seed page's image the way its upstream came to draw it: each cosine computed once, Fresnel's x^5 by multiplication,
// the denominator of D clamped. SUNS is given by the preprocessor; varyings and uniforms are those of the seed's vertex shader.
precision highp float;

varying vec2 uv;
varying vec3 viewWorld;
varying mat3 worldTBN;

uniform sampler2D uTextureAlbedo;
uniform sampler2D uTextureNormal;
uniform vec4 uMaterialAlbedoColor;
uniform float uMaterialMetallic;
uniform float uMaterialRoughness;
uniform vec3 uAmbientColor;
uniform vec3 uLightDir[SUNS];
uniform vec3 uLightRadiance[SUNS];

const float kPi = 3.14159265;

// Schlick 1994: the weight of white at a half-vector cosine.
float fresnelWeight(float vDotH) {
  float x = 1.0 - vDotH;
  float x2 = x * x;
  return x2 * x2 * x;
}

// Trowbridge-Reitz with alpha = roughness^2, 1/sr.
float distribution(float nDotH, float alpha2) {
  float d = nDotH * nDotH * (alpha2 - 1.0) + 1.0;
  return alpha2 / max(kPi * d * d, 1e-6);
}

// Schlick-GGX, one direction.
float masking(float cosine, float k) {
  return cosine / (cosine * (1.0 - k) + k);
}

void main() {
  vec4 texel = texture2D(uTextureAlbedo, uv) * uMaterialAlbedoColor;
  vec3 albedo = texel.rgb;
  vec3 n = normalize(worldTBN * (texture2D(uTextureNormal, uv).xyz * 2.0 - 1.0));
  vec3 v = normalize(viewWorld);
  float nDotV = max(dot(n, v), 0.0);

  float alpha = uMaterialRoughness * uMaterialRoughness;
  float alpha2 = alpha * alpha;
  float r = uMaterialRoughness + 1.0;
  float k = r * r / 8.0;
  float maskingV = masking(nDotV, k);
  vec3 f0 = mix(vec3(0.04), albedo, uMaterialMetallic);
  vec3 diffuse = albedo * ((1.0 - uMaterialMetallic) / kPi);

  vec3 colour = albedo * pow(uAmbientColor, vec3(2.2));
  for (int i = 0; i < SUNS; ++i) {
    vec3 l = -uLightDir[i];
    vec3 h = normalize(v + l);
    float nDotL = max(dot(n, l), 0.0);
    float nDotH = max(dot(n, h), 0.0);
    float vDotH = max(dot(v, h), 0.0);
    vec3 fresnel = f0 + (1.0 - f0) * fresnelWeight(vDotH);
    float lobe = distribution(nDotH, alpha2) * maskingV * masking(nDotL, k) / max(4.0 * nDotV * nDotL, 0.001);
    colour += ((1.0 - fresnel) * diffuse + fresnel * lobe) * uLightRadiance[i] * nDotL;
  }
  gl_FragColor = vec4(colour, texel.a);
}
