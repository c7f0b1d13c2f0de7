// The frame in which the normal map is flat: light vectors are brought into it, so that texels need no
// turning. The map's scale lies in its x and y axes.
//! declarations
uniform float uNormalScale; // material: glTF's normalTexture.scale
//! main
  toCamera = normalize(toCamera);
  tangent *= uNormalScale;
  vec3 bitangent = cross(normal, tangent) * aTangent.w;
  vec3 eye = vec3(dot(toCamera, tangent), dot(toCamera, bitangent), dot(toCamera, normal));
