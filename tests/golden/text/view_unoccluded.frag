#version 100
// FrankenShader view-occlusion
//   view: view-occlusion
//
// FRAGMENT SHADER
//
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

void main() {
  vec3 color = vec3(1.0);

  gl_FragColor = vec4(color, 1.0);
}
