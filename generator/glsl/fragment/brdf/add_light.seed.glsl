// SPDX-License-Identifier: MIT
// What a surface reflects of one light, by the BRDF of the page that this library is named after.
//! functions
void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // One F_0 = mix(0.04, base, metalness) for both layers, and V's divisor 4 N.L N.V kept above 0.001. Of the lobe,
  // Schlick's term goes to the rim, which nothing tints; the rest is F_0's.
  Angles angles = anglesOf(light, view);
  float kept = min(4000.0 * view.nDotV * angles.nDotL, 1.0);
  float specular = kept * (specularLobe(angles, view.nDotV, surface) * angles.nDotL);
  float rim = angles.fresnel * specular;
  float face = specular - rim;
  sum.specular += (rim + surface.dielectric * face) * light.radiance;
  float entering = angles.nDotL - angles.fresnel * angles.nDotL;
  vec3 absorbed = entering * surface.tinted * surface.base;
  sum.diffuse += light.radiance * (entering * surface.diffuse + face * surface.metal - absorbed);
}
