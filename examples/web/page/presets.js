// SPDX-License-Identifier: MIT
// The pages about physically based rendering that this library learnt from, as states of this one. `notes` says what
// was mapped to what.

const kFrom000 = [[0, -1, 10], [1, 1, 10], [-1, 1, 10]];

/** 3,000 W of all directions. */
const kFlux = 3000 / (4 * Math.PI);

/** Of generator/docs/sky.md: mean codes of metal spheres, by tests/assets. */
const kAgainstTruth = "Against brute force under a sunset, our reflection is 1.2, 1.7 and 1.4 codes off in the mean for metal of roughness 0.2, 0.6 and 1; a plain split sum is 1.9, 10.1 and 14.5.";

const kSeed = "basecolor.normal+seed+decode-none+linear";
const kSeedNumbers = { red: 1, green: 1, blue: 1, metallic: 0, roughness: 0.6, shape: "sphere" };
const kKeptEye = "N.V is kept above 0.0001 here and above 0 there, which shows where a normal map turns a normal away from the eye";
const kSeedNotes = `Its shader, word by word: Schlick-GGX with (roughness + 1)² / 8, textures taken as linear, and nothing encoded. Its ambient colour is raised to 2.2 on the CPU; a sun's radiance of 1 is 1 lux. Its bitangent points the other way: our texture's green is turned for it. In its sun, ${kKeptEye}: of metal, up to 8 codes in 0.004 % of the picture. With our bound in its place, or without metal, a sun and an ambient colour differ by one code at most.`;

export const kPresets = {
  "004 ambient": {
    title: "FrankenShader: ambient colour",
    state: { name: kSeed.replace("+", "+ambient+"), ...kSeedNumbers, ambient: 0.3 },
    notes: kSeedNotes,
  },
  "004 sky": {
    title: "FrankenShader: sky",
    state: { name: kSeed.replace("+", "+sh+"), ...kSeedNumbers },
    notes: `${kSeedNotes} It lights by a blurred skybox, we by nine coefficients of a sky's irradiance.`,
  },
  "004 sky and sun": {
    title: "FrankenShader: sky and sun",
    state: { name: kSeed.replace("+", "+sh+sun1+"), ...kSeedNumbers, lux: 3.1 },
    notes: `${kSeedNotes} It lights by a blurred skybox, we by nine coefficients of a sky's irradiance.`,
  },
  "004 sun": {
    title: "FrankenShader: sun alone",
    state: { name: kSeed.replace("+", "+sun1+"), ...kSeedNumbers, lux: 3.1 },
    notes: kSeedNotes,
  },
  "000": {
    title: "Three point lights",
    state: {
      name: "ambient+punctual3+fast+reinhard+pow22", shape: "sphere", red: 1, green: 0, blue: 0, metallic: 0,
      roughness: 0.1, ambient: 0.2, candela: kFlux, yaw: 0, pitch: 0,
    },
    lights: { punctual: kFrom000.map((position) => ({ position, color: [1, 1, 1], intensity: kFlux, range: 100 })) },
    notes: "Its roughness slider is our roughness (it squares it). Its visibility is Hammon's: `fast`. Each of its lights has a radiant flux of 3,000, which is 3,000 / 4π in every direction; its window of range is glTF's. Reinhard, then 1/2.2. Its ambient light of 0.2 is our ambient colour. With metallic 0 or 1 the pictures differ by one code at most. Between them it dims the diffuse light by the Fresnel term of the mixture, and glTF mixes two surfaces, each with its own: 16 codes at 0.5. With a dielectric's term in that place, it is one code again.",
  },
  "002": {
    title: "Textures and environment",
    state: {
      name: "basecolor.metalrough-separate.normal.occlusion+sh+reflection+punctual1+seed+reinhard+pow22",
      shape: "sphere", red: 1, green: 1, blue: 1, metallic: 1, roughness: 1, candela: 20,
    },
    lights: { punctual: [{ position: [2, 2, 3], color: [1, 1, 1] }] },
    notes: `It decodes base colours by 2.2; we have no word for that and take sRGB's curve. Without its environment, and with decoded textures, 99.97 % of the picture is within one code of its functions, and all of it within 7. Two bounds make the rest: its divisor 4 N.L N.V is kept above 0 by adding 0.0001, ours by a floor of 0.001; and ${kKeptEye}. With both of ours in its text, it is one code at most. Its environment is a split sum. ${kAgainstTruth} One point light, Reinhard, 1/2.2.`,
  },
  "003": {
    title: "Metal in an environment",
    state: {
      name: "sh+reflection+punctual1+srgb-fast", shape: "sphere", red: 0.69, green: 0, blue: 0, metallic: 0.865,
      roughness: 0.18, candela: 20,
    },
    lights: { punctual: [{ position: [2, 2, 3], color: [1, 1, 1] }] },
    notes: `It names F, G and D for punctual light and gives no formulas of G and D; ours are glTF's. It adds all diffuse light to what is mirrored, which glTF takes out of it: 2 codes in its own settings. With diffuse light dimmed by a dielectric's Fresnel term, the rest of its formulas is one code at most from ours. It looks the diffuse light of its environment up in the mirrored direction and encodes each fetch by 1/2.2 before it adds; we light by the irradiance at the normal, add in linear light, and encode once. ${kAgainstTruth}`,
  },
};
