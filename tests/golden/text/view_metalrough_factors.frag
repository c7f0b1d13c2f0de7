#version 100
// FrankenShader view-metalrough
//   view: view-metalrough
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform vec2 uMetallicRoughness; // material: factors, 0-1

void main() {
  float metallic = uMetallicRoughness.x;
  float roughness = uMetallicRoughness.y;

  vec3 color = vec3(0.0, roughness, metallic);

  gl_FragColor = vec4(color, 1.0);
}
