// SPDX-License-Identifier: MIT
// What the page shows, and its form in the address bar: "#NAME;key=value;…", with what is not usual alone.

const direction = (azimuth, height) => {
  const [a, h] = [azimuth, height].map((degrees) => degrees * Math.PI / 180);
  return [-Math.sin(a) * Math.cos(h), -Math.sin(h), -Math.cos(a) * Math.cos(h)];
};

/** Where suns 2 to 4 stand; the first has sliders. */
const kOtherSuns = [[-60, 20], [150, 35], [60, -25]];
const kPunctualPlaces = [[1.6, 1.4, 2], [-2, 0.5, 1.5], [0, -1.8, 2], [0.5, 2.4, -1]];
const kPunctualColors = [[1, 0.95, 0.9], [0.7, 0.8, 1], [1, 0.7, 0.5], [0.8, 1, 0.8]];

/** Each number that has a slider: its title, range, step, and usual value. */
export const kNumbers = {
  red: ["Base colour: red", 0, 1, 0.01, 0.8],
  green: ["green", 0, 1, 0.01, 0.8],
  blue: ["blue", 0, 1, 0.01, 0.8],
  alpha: ["alpha", 0, 1, 0.01, 1],
  metallic: ["Metallic", 0, 1, 0.01, 0],
  roughness: ["Roughness", 0, 1, 0.01, 0.4],
  normalScale: ["Normal map: scale", 0, 2, 0.05, 1],
  occlusion: ["Occlusion: strength", 0, 1, 0.05, 1],
  glow: ["Emission", 0, 4, 0.05, 1],
  cutoff: ["Alpha cutoff", 0, 1, 0.05, 0.5],
  exposure: ["Exposure (stops)", -4, 4, 0.1, 0],
  ambient: ["Ambient colour", 0, 1, 0.01, 0.2],
  lux: ["Suns (lux)", 0, 20, 0.1, 3.1],
  azimuth: ["First sun: azimuth °", -180, 180, 1, 40],
  height: ["First sun: height °", -90, 90, 1, 40],
  candela: ["Punctual lights (cd)", 0, 500, 0.5, 8],
};

const kUsual = Object.fromEntries(Object.entries(kNumbers).map(([key, [, , , , usual]]) => [key, usual]));

export const kFirst = { name: "basecolor.normal+ambient+sun1", shape: "sphere", preset: "", yaw: 20, pitch: 15, distance: 4.2, ...kUsual };

/** A state from an address; what it does not say is as usual. */
export function readState(hash) {
  const [name, ...pairs] = decodeURIComponent(hash.replace(/^#/, "")).split(";");
  const state = { ...kFirst, name: name || kFirst.name };
  for (const pair of pairs) {
    const [key, value] = pair.split("=");
    if (!(key in kFirst) || value === undefined)
      continue;
    if (typeof kFirst[key] === "string")
      state[key] = value;
    else if (Number.isFinite(Number(value)))
      state[key] = limited(key, Number(value));
  }
  return state;
}

function limited(key, value) {
  const [, least, most] = kNumbers[key] ?? { distance: [0, 0.1, 1e6], pitch: [0, -89, 89] }[key] ?? [0, -1e6, 1e6];
  return Math.min(Math.max(value, least), most);
}

export function writeState(state) {
  const pairs = Object.keys(kFirst)
    .filter((key) => key !== "name" && state[key] !== kFirst[key])
    .map((key) => `;${key}=${typeof state[key] === "number" ? Number(state[key].toFixed(3)) : state[key]}`);
  return `#${state.name}${pairs.join("")}`;
}

/** The suns and punctual lights of a state, as many as its words say; a preset may bring its own. */
export function lightsOf(state, words, own = {}) {
  const count = (prefix) => [1, 2, 3, 4].find((n) => words.has(`${prefix}${n}`)) ?? 0;
  const places = [[state.azimuth, state.height], ...kOtherSuns];
  const suns = Array.from({ length: count("sun") }, (_, i) => own.suns?.[i] ?? {
    direction: direction(...places[i]), color: [1, 1, 1], illuminance: state.lux,
  });
  const punctual = Array.from({ length: count("punctual") }, (_, i) => ({
    position: kPunctualPlaces[i], color: kPunctualColors[i], direction: kPunctualPlaces[i].map((x) => -x),
    intensity: state.candela, range: 0, spot: words.has("spots"), inner: 0.2, outer: 0.45, ...own.punctual?.[i],
  }));
  return { suns, punctual };
}

/** Where the camera stands. */
export function eyeOf({ yaw, pitch, distance }, target) {
  const [y, p] = [yaw, pitch].map((degrees) => degrees * Math.PI / 180);
  return [
    target[0] + distance * Math.sin(y) * Math.cos(p),
    target[1] + distance * Math.sin(p),
    target[2] + distance * Math.cos(y) * Math.cos(p),
  ];
}
