// The sky's light, by what it becomes: scattered, mirrored with the base colour's tint, and mirrored without. It is
// tinted here, and so is each light of its own: a sum that is live while textures are waited for takes three
// registers instead of six.
//! main
  vec3 color = mirrored * (skyShare.y * base.rgb + skyShare.z) + (irradiance * skyShare.x) * base.rgb;
