// How long the normal and the vector to the eye are, and how much the surface faces the eye: for one or two
// lights, scaling products is cheaper than scaling vectors. The length that V has after scaling is used as
// it is: an inexact root (roots on VideoCore IV) then errs alike in N.(V+L) and |V+L|, whose difference is
// the width of a highlight. N.V is kept off 0, where visibility would divide by it.
//! main
  vec2 squares = vec2(dot(normal, normal), dot(vToCamera, vToCamera));
  vec2 scale = vec2(inverseRoot(squares.x), inverseRoot(squares.y));
  squares.y = squares.y * (scale.y * scale.y) + 1.000002;
  float facing = max(dot(normal, vToCamera) * scale.y, 5.0e-5);
  float nDotV = facing * scale.x;
