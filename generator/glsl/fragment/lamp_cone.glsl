// Cones: KHR_lights_punctual, "Inner and Outer Cone Angles". A point light has scale 0 and offset 1.
//! functions
// axis: where the lamp shines, unit. cone: scale and offset that packLamp made from both angles.
float lampCone(vec3 toLamp, vec3 axis, vec2 cone) {
  float c = clamp(cone.y - dot(toLamp, axis) * cone.x, 0.0, 1.0);
  return c * c;
}
