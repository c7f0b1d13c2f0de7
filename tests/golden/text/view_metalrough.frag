#version 100
// FrankenShader metalrough-separate+view-metalrough
//   metallicRoughness: metalrough-separate
//   view: view-metalrough
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

varying vec2 vUv0;

uniform vec2 uMetallicRoughness; // material: factors, 0-1

uniform sampler2D uMetallicTexture; // material: R, linear
uniform sampler2D uRoughnessTexture; // material: R, linear

void main() {
  float metallic = texture2D(uMetallicTexture, vUv0).r * uMetallicRoughness.x;
  float roughness = texture2D(uRoughnessTexture, vUv0).r * uMetallicRoughness.y;

  vec3 color = vec3(0.0, roughness, metallic);

  gl_FragColor = vec4(color, 1.0);
}
