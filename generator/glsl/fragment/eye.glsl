// The direction to the eye, and how much the surface faces it. Kept off 0, where visibility would divide
// by it.
//! main
  vec3 toCamera = vToCamera * inverseRoot(dot(vToCamera, vToCamera));
  float nDotV = max(dot(normal, toCamera), 1.0e-4);
