// SPDX-License-Identifier: MIT
// What a program costs on the Pi's GPUs: from the committed table where it is in there, else computed from the price
// list (tests/qpu), and marked so.

const kGpus = [["vc4", "vc4: Pi 0–3"], ["v3d42", "v3d 4.2: Pi 4"], ["v3d71", "v3d 7.1: Pi 5"]];

/** The program that the price list starts from, in words; all others are its differences. */
const kBase = new Set(["basecolor", "normal", "ambient", "sun1", "decode-fast", "srgb-fast"]);

/** By word: the lines of the price list that it adds to a program without it. */
const kItems = {
  "basecolor": ["base colour texture"],
  "vertexcolor": ["vertex colour"],
  "normal": ["normal map"],
  "metalrough": ["metallic-roughness texture"],
  "metalrough-separate": ["metalness and roughness, two textures"],
  "occlusion": ["occlusion texture"],
  "occlusion-packed": ["occlusion in the metallic-roughness texture"],
  "emissive-factor": ["emission by factor"],
  "emissive": ["emissive texture"],
  "mask": ["alpha mask"],
  "blend": ["alpha blending"],
  "double": ["double-sided"],
  "uv0-transform": ["texture transform"],
  "uv1-transform": ["texture transform"],
  "skin1": ["skin, 1 joint a vertex"],
  "skin2": ["skin, 2 joints a vertex"],
  "skin3": ["skin, 3 joints a vertex"],
  "skin4": ["skin, 4 joints a vertex"],
  "ambient": ["ambient colour"],
  "sh": ["ambient colour", "sky (SH) instead of the ambient colour"],
  "reflection": ["reflection of the sky as well"],
  "sun1": ["1st sun"],
  "sun2": ["1st sun", "2nd sun"],
  "sun3": ["1st sun", "2nd sun", "3rd and 4th sun, together"],
  "sun4": ["1st sun", "2nd sun", "3rd and 4th sun, together"],
  "punctual1": ["1st punctual light"],
  "punctual2": ["1st punctual light", "2nd punctual light"],
  "punctual3": ["1st punctual light", "2nd punctual light", "2nd punctual light"],
  "punctual4": ["1st punctual light", "2nd punctual light", "2nd punctual light", "2nd punctual light"],
  "spots": ["the light is a spot"],
  "vertexlight": ["light vectors per vertex, 1 sun"],
  "seed": ["BRDF of the seed instead of glTF's"],
  "fast": ["BRDF fast instead of glTF's"],
  "schlick": ["BRDF schlick instead of glTF's"],
  "decode-srgb": ["exact sRGB decode instead of the cubic"],
  "decode-none": ["no decode instead of the cubic"],
  "srgb": ["exact sRGB encode instead of the fast one"],
  "pow22": ["encode by 1/2.2 instead of fast sRGB"],
  "linear": ["no encode instead of fast sRGB"],
  "reinhard": ["tone map: Reinhard"],
  "aces": ["tone map: ACES"],
  "neutral": ["tone map: Khronos neutral"],
  "dither": ["dither"],
};
/** The one word whose price depends on others. */
function energyItem(words) {
  if (words.has("reflection"))
    return "energy, with the reflection of the sky";
  const isTextured = words.has("metalrough") || words.has("metalrough-separate");
  return isTextured ? "energy, roughness by texture" : "energy, roughness by factor";
}

/** Words that the price list says nothing of: programs that have them are too far from what it starts from. */
const kUnpriced = ["sky", "overlay", "unlit", "fp16", "view-basecolor", "view-normal", "view-metalrough", "view-occlusion"];
const kSecondStream = /-uv1$/;

/** "−3 (+47)": fragment, and vertex with coordinate shader. */
export function parseNumbers(cell) {
  const number = (text) => Number(text.replace("−", "-"));
  const match = /^([+−]?\d+)[^(]*(?:\(([+−]?\d+)\))?$/.exec(cell.trim());
  return match ? { fragment: number(match[1]), vertex: match[2] ? number(match[2]) : 0 } : null;
}

export class Prices {
  constructor(table, list) {
    this.measured = new Map(table.trim().split("\n").slice(1).map((line) => {
      const [gpu, name, outcome, fragment, threads, , , , , vertex, coordinate] = line.split("\t");
      return [`${gpu} ${name}`, { outcome, fragment: Number(fragment), threads, vertex: Number(vertex) + Number(coordinate) }];
    }));
    this.list = new Map(list.trim().split("\n").slice(2).map((line) => {
      const [feature, ...cells] = line.split("|").slice(1, -1).map((cell) => cell.trim());
      return [feature.replaceAll("`", ""), cells.map(parseNumbers)];
    }));
    this.base = [...this.list.values()][0];
  }

  /** The features of the list that stand between the base and a program of these words; null where it cannot tell. */
  difference(words) {
    if ([...words].some((word) => kUnpriced.includes(word)))
      return null;
    const itemsOf = (word) => kItems[word] ?? (kSecondStream.test(word) ? ["second texture coordinates"] : []);
    const more = [...words].filter((word) => !kBase.has(word)).flatMap(itemsOf);
    if (words.has("energy"))
      more.push(energyItem(words));
    const less = [...kBase].filter((word) => !words.has(word)).flatMap((word) => kItems[word] ?? []);
    return { more, less };
  }

  /** {fragment, vertex, measured, note} for each GPU. `words` are all of the program's, defaults spelled out. */
  of(name, words) {
    return kGpus.map(([gpu, title], column) => {
      const measured = this.measured.get(`${gpu} ${name}`);
      if (measured)
        return { title, ...measured, measured: true };
      const steps = this.difference(words);
      if (!steps)
        return { title, measured: false };
      const sum = { ...this.base[column] };
      for (const [features, sign] of [[steps.more, 1], [steps.less, -1]])
        for (const feature of features)
          for (const part of ["fragment", "vertex"])
            sum[part] += sign * this.list.get(feature)[column][part];
      return { title, ...sum, measured: false };
    });
  }
}

/** Megapixels a second that vc4 shades at most, by design: 14.4 G instructions a second (tests/qpu). */
const kVc4Instructions = 14400;

export function priceTable(prices) {
  const table = document.createElement("table");
  const row = (cells, kind) => {
    const line = table.insertRow();
    cells.forEach((text, i) => {
      const isTitle = i === 0 || kind === "th";
      const cell = document.createElement(isTitle ? "th" : "td");
      if (isTitle)
        cell.scope = kind === "th" ? "col" : "row";
      cell.textContent = text;
      line.append(cell);
    });
  };
  row(["GPU", "Fragment", "Vertex and coordinate", "How it is known"], "th");
  for (const { title, outcome, fragment, threads, vertex, measured } of prices) {
    if (fragment === undefined)
      row([title, "–", "–", "not in the price list: ask `frankenshader cost`"]);
    else if (measured)
      row([title, outcome === "ok" ? `${fragment}, ${threads} threads` : outcome, `${vertex}`, "measured by Mesa's compiler"]);
    else
      row([title, `≈ ${fragment}`, `≈ ${vertex}`, "computed from the price list"]);
  }
  const [{ fragment }] = prices;
  const note = document.createElement("p");
  if (fragment > 0)
    note.textContent = `On a Pi 3, at most ${(kVc4Instructions / fragment).toFixed(0)} megapixels a second; a full screen of 1920×1080 at 60 Hz is 124.`;
  return [table, note];
}
