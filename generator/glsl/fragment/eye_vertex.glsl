// The direction to the eye as the vertex shader normalised it: unit but for what shrinks between vertices.
//! main
  vec3 toCamera = vToCamera;
