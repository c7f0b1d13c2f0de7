#version 100
// FrankenShader double+view-normal+workaround-facing
//   sides: 1
//   view: view-normal
//   facingWorkaround: 1
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

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

void main() {
  vec3 normal = vNormal * inverseSquareRoot(dot(vNormal, vNormal));
  if (dot(vNormal, vToCamera) < 0.0) normal = -normal;

  vec3 color = 0.5 + 0.5 * normal;

  gl_FragColor = vec4(color, 1.0);
}
