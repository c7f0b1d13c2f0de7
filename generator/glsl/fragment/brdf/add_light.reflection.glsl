// SPDX-License-Identifier: MIT
// What a surface reflects of one light, tinted at once.
//! functions
void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, sorted by what the base colour tints. Schlick's F is
  // F_0 (1 - x^5) + F_90 x^5, and F_90 is 1, which nothing tints.
  Angles angles = anglesOf(light, view);
  float weightF0 = angles.arriving - angles.arriving * angles.fresnel;
  float specular = specularLobe(angles, view.nDotV, surface);
  float tinted = weightF0 * (surface.diffuse + surface.metal * specular);
  float untinted = (angles.arriving - weightF0 * surface.oneMinusF0) * specular;
  sum.color += (surface.base * tinted + untinted) * light.radiance;
}
