// SPDX-License-Identifier: MIT
// What a surface reflects of one light.
//! functions
void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // glTF 2.0, appendix B: its mix of a dielectric and a metal, sorted by what the base colour tints. Of the lobe,
  // Schlick's term goes to the rim, which nothing tints; the rest is F_0's.
  Angles angles = anglesOf(light, view);
  float entering = angles.nDotL - angles.nDotL * angles.fresnel;
  float specular = specularLobe(angles, view.nDotV, surface);
  sum.diffuse += light.radiance * (entering * (surface.metal * specular + surface.diffuse));
  sum.specular += light.radiance * (specular * (angles.nDotL - entering * surface.clear));
}
