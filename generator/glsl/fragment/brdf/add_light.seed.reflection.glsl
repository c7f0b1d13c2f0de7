// SPDX-License-Identifier: MIT
// What a surface reflects of one light, by the BRDF of the page that this library is named after; tinted at once.
//! functions
void addLight(Light light, View view, Surface surface, inout Sum sum) {
  // One F_0 = mix(0.04, base, metalness) for both layers, and V's divisor 4 N.L N.V kept above 0.001. Schlick's
  // F is F_0 (1 - x^5) + F_90 x^5, and F_90 is 1, which nothing tints.
  Angles angles = anglesOf(light, view);
  float kept = min(4000.0 * angles.nDotL * view.nDotV, 1.0);
  float specular = angles.arriving * kept * specularLobe(angles, view.nDotV, surface);
  float lobeF90 = angles.fresnel * specular;
  float lobeF0 = specular - lobeF90;
  float weightF0 = angles.arriving - angles.arriving * angles.fresnel;
  vec3 absorbed = weightF0 * surface.tinted * surface.base;
  vec3 tinted = surface.diffuse * weightF0 + lobeF0 * surface.metal - absorbed;
  sum.color += (surface.base * tinted + (surface.dielectric * lobeF0 + lobeF90)) * light.radiance;
}
