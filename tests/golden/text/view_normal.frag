#version 100
// FrankenShader normal.double+view-normal
//   normal: 1
//   sides: 1
//   view: view-normal
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
varying vec3 vTangent;
varying vec3 vBitangent;

uniform sampler2D uNormalTexture; // material: tangent space, +Y up the texture, linear

float inverseSquareRoot(float x) {
  return inversesqrt(x);
}

// texel: as stored. The frame's axes may have any length; x and y carry the map's scale.
vec3 mapNormal(vec3 texel, vec3 tangent, vec3 bitangent, vec3 normal) {
  vec3 n = texel - 0.5;
  n = n.x * tangent + n.y * bitangent + n.z * normal;
  return n * inverseSquareRoot(dot(n, n));
}

void main() {
  vec3 normal = mapNormal(texture2D(uNormalTexture, vUv0).xyz, vTangent, vBitangent, vNormal);
  if (!gl_FrontFacing) normal = -normal;

  vec3 color = 0.5 + 0.5 * normal;

  gl_FragColor = vec4(color, 1.0);
}
