// How long the normal and the vector to the eye are, and how much the surface faces the eye: for one or two
// lights, scaling products is cheaper than scaling vectors. N.V is kept off 0, where visibility would divide
// by it.
//! main
  vec2 scale = vec2(inverseRoot(dot(normal, normal)), inverseRoot(dot(vToCamera, vToCamera)));
  float nDotV = max(dot(normal, vToCamera) * (scale.y * scale.x), 1.0e-4);
