// The base colour's texel, to linear light.
//! main
  base.rgb = decodeSrgb(base.rgb);
