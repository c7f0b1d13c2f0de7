#version 100
// FrankenShader
//   transform/position: 1
//   streams/uv0: 1
//   frame/normal: 1
//   frame/normal_varying: 1
//   frame/to_camera: 1
//   frame/to_camera_varying: 1
//   frame/tangent: 1
//   frame/tangent_varying: 1
//
// VERTEX SHADER
//
attribute vec3 aPosition;
attribute vec2 aUv0;
attribute vec3 aNormal;
attribute vec4 aTangent; // xyz: direction of +U; w: +1 or -1, the bitangent's side

varying vec2 vUv0;
varying vec3 vNormal;
varying vec3 vToCamera;
varying vec3 vTangent;
varying vec3 vBitangent;

uniform vec3 uCameraPosition; // frame: world space
uniform float uNormalScale; // material: glTF's normalTexture.scale
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
  vNormal = normal;
  vec3 toCamera = uCameraPosition - (uModel * vec4(aPosition, 1.0)).xyz;
  vToCamera = toCamera;
  vec3 tangent = safeNormalize((uModel * vec4(aTangent.xyz, 0.0)).xyz);
  vTangent = tangent * uNormalScale;
  vBitangent = cross(normal, tangent) * (aTangent.w * uNormalScale);
}
