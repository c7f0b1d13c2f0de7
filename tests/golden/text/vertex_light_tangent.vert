#version 100
// FrankenShader
//   transform/position: 1
//   streams/uv0: 1
//   frame/normal: 1
//   frame/to_camera: 1
//   frame/tangent: 1
//   frame/tangent_space: 1
//   sun/tangent_space: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
attribute vec2 aUv0;
attribute vec3 aNormal;
attribute vec4 aTangent; // xyz: direction of +U; w: +1 or -1, the bitangent's side

varying vec2 vUv0;
varying vec4 vToSun0;
varying vec3 vHalfSun0;

uniform vec3 uCameraPosition; // frame: world space
uniform vec3 uSun0Direction; // lights: towards the sun, unit, world space
uniform mat4 uModelViewProjection; // object: model space to clip space
uniform mat3 uNormalMatrix; // object: inverse transpose of the model matrix
uniform mat4 uModel; // object: model space to world space

vec3 safeNormalize(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1.0e-12));
}

void main() {
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);

  vUv0 = aUv0;

  vec3 normal = normalize(uNormalMatrix * aNormal);
  vec3 toCamera = uCameraPosition - (uModel * vec4(aPosition, 1.0)).xyz;
  vec3 tangent = safeNormalize((uModel * vec4(aTangent.xyz, 0.0)).xyz);
  toCamera = normalize(toCamera);
  vec3 bitangent = cross(normal, tangent) * aTangent.w;
  vec3 eye = vec3(dot(toCamera, tangent), dot(toCamera, bitangent), dot(toCamera, normal));

  vec3 toSun0 = vec3(dot(uSun0Direction, tangent), dot(uSun0Direction, bitangent), dot(uSun0Direction, normal));
  float xSun0 = 1.0 - sqrt(0.5 * dot(toCamera, uSun0Direction) + 0.5);
  vToSun0 = vec4(toSun0, xSun0 * xSun0 * xSun0 * xSun0 * xSun0);
  vHalfSun0 = eye + toSun0;
  vHalfSun0.z += 1.0e-4;
}
