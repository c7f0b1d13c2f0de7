// SPDX-License-Identifier: MIT
// What a surface reflects of one light, with what is scattered between its facets; tinted at once.
//! functions
void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, each times 1 + F_0 (1 / E - 1): Turquin, "Practical
  // multiple scattering compensation for microfacet models", 2019, equation 16. Sorted by powers of the base colour.
  Angles angles = anglesOf(light, view);
  float weightF90 = angles.arriving * angles.fresnel;
  float weightF0 = angles.arriving - weightF90;
  float specular = specularLobe(angles, view.nDotV, surface);
  float metal = surface.metal * specular;
  float metalF0 = metal * weightF0;
  float squared = surface.compensation * metalF0;
  float tinted = weightF0 * surface.diffuse + (metalF0 + surface.compensation * (metal * weightF90));
  float once = specular * (angles.arriving - weightF0 * surface.oneMinusF0);
  float untinted = once * (1.0 + surface.compensation - surface.compensation * surface.oneMinusF0);
  sum.color += (surface.base * (surface.base * squared + tinted) + untinted) * light.radiance;
}
