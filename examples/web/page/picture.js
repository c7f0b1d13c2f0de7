// SPDX-License-Identifier: MIT
// A frame: the state's numbers folded by the library, and each of the scene's items drawn with its program.
import { Driver, meshOf } from "./driver.js";
import { kIdentity3, kIdentity4 } from "./scene.js";
import { eyeOf, lightsOf } from "./state.js";
import { kNoSky } from "./sky.js";

const kAngle = Math.PI / 5; // Of view, from top to bottom, radians.
const kBits = 8;
const kBackground = [0.13, 0.13, 0.14];

/** Brdf, ambient light and precision as the library counts them. */
const indexOf = (words, options) => Math.max(options.findIndex((word) => words.has(word)), 0);
const kBrdfs = ["gltf", "seed", "fast", "schlick"];
const kAmbients = ["no-ambient", "ambient", "sh"];
const kPrecisions = ["fp32", "fp16"];

function quad() {
  const positions = Float32Array.of(-0.8, -0.8, 0, 0.8, -0.8, 0, 0.8, 0.8, 0, -0.8, 0.8, 0);
  const colors = Float32Array.of(1, 0.4, 0.2, 1, 0.2, 1, 0.4, 1, 0.2, 0.4, 1, 1, 1, 1, 1, 1);
  return meshOf({ positions, uv0: Float32Array.of(0, 1, 1, 1, 1, 0, 0, 0), colors }, Uint32Array.of(0, 1, 2, 0, 2, 3));
}

export class Picture {
  constructor(canvas, library, { roles, blocks }, onChange) {
    this.blockFloats = blocks;
    this.canvas = canvas;
    this.packed = {};
    this.library = library;
    this.driver = new Driver(canvas, roles, onChange);
    this.behindAll = meshOf({ positions: Float32Array.of(-1, -1, 1, 3, -1, 1, -1, 3, 1) }, Uint32Array.of(0, 1, 2));
    this.quad = quad();
  }

  /** describe(name) gives a program's description. */
  draw({ state, scene, sky = kNoSky, own, describe }) {
    const { canvas, driver } = this;
    this.describe = describe;
    const main = describe(state.name);
    const view = this.viewOf(state, scene);
    this.frame = this.pack("packFrame", "frame", [view.numbers, sky.skyRange, sky.reflectionRange, 2 ** state.exposure, kBits,
      indexOf(main.words, kPrecisions), view.farthest]);
    this.lights = this.pack("packLights", "lights", this.lightNumbers(state, main.words, sky, own, view));
    this.skin = this.pack("packSkin", "skin", []);
    driver.begin(canvas.width, canvas.height, kBackground);
    if (main.words.has("sky"))
      return this.drawBehind(main, sky, state);
    if (sky.cube && main.words.has("sh"))
      this.drawBehind(describe(skyName(main.words)), sky, state);
    if (main.words.has("overlay"))
      return this.drawItem({ mesh: this.quad, world: kIdentity4, mirrored: false }, main, state, scene, sky);
    for (const item of this.sorted(scene, state, view))
      this.drawItem(item, item.described, state, scene, sky);
  }

  viewOf(state, scene) {
    const { canvas } = this;
    const middle = scene.least.map((x, i) => (x + scene.most[i]) / 2);
    const radius = Math.hypot(...scene.most.map((x, i) => x - middle[i])) || 1;
    const scale = scene.isOwn ? 1 : radius / 1.15; // The sphere's distances fit any model.
    const eye = eyeOf({ ...state, distance: state.distance * scale }, middle);
    const distance = state.distance * scale;
    const near = Math.max(distance - 1.05 * radius, distance / 100);
    return {
      eye, farthest: distance + radius,
      numbers: [eye, middle, kAngle, canvas.width / canvas.height, near, distance + 2 * radius],
    };
  }

  /** What shows through is drawn last. */
  sorted(scene, state, view) {
    const items = scene.items.map((item) => ({
      ...item,
      described: item.material ? this.describe(this.library.withMaterial(state.name, item.material.permutation)) : this.describe(state.name),
    }));
    const depth = ({ world }) => Math.hypot(...view.eye.map((x, i) => x - world[12 + i]));
    const rank = (item) => item.described.words.has("blend") ? 1 / (1 + depth(item)) : -1;
    return items.sort((a, b) => rank(a) - rank(b));
  }

  lightNumbers(state, words, sky, own, view) {
    const { suns, punctual } = lightsOf(state, words, withSun(own, sky, words));
    return [
      2 ** state.exposure, view.eye, indexOf(words, kPrecisions), view.farthest, indexOf(words, kAmbients),
      Array(3).fill(own?.ambient ?? state.ambient), sky.coefficients,
      suns.length, suns.map((sun) => [sun.direction, sun.color, sun.illuminance]),
      punctual.length, punctual.map((light) => [light.position, light.direction, light.color, light.intensity, light.range,
        light.spot ? 1 : 0, light.inner, light.outer]),
    ];
  }

  materialNumbers(item, words, state, scene) {
    const transforms = item.material ? [item.material.uv0, item.material.uv1] : scene.transforms ?? [kIdentity3, kIdentity3];
    const factors = item.material ? Object.values(item.material.factors) : [
      [state.red, state.green, state.blue, state.alpha], state.metallic, state.roughness, state.normalScale, state.occlusion,
      Array(3).fill(state.glow), state.cutoff,
    ];
    return [indexOf(words, kBrdfs), indexOf(words, kPrecisions), 2 ** state.exposure, factors, transforms];
  }

  drawItem(item, described, state, scene, sky) {
    const material = this.pack("packMaterial", "material", this.materialNumbers(item, described.words, state, scene));
    const object = this.pack("packObject", "object", [item.world, item.mirrored ? 1 : 0]);
    const all = { frame: this.frame, lights: this.lights, skin: this.skin, material, object };
    const isFlat = described.words.has("overlay");
    this.driver.draw({
      described, mesh: item.mesh, mirrored: item.mirrored,
      doubleSided: isFlat || described.words.has("double"),
      blocks: (block, offset, floats) => all[block].subarray(offset, offset + floats),
      textures: this.texturesFor(item, described, scene, sky),
    });
  }

  drawBehind(described, sky, state) {
    this.drawItem({ mesh: this.behindAll, world: kIdentity4, mirrored: false, material: null }, described, { ...state }, {}, sky);
  }

  texturesFor(item, described, scene, sky) {
    const skyTextures = { uSkyTexture: sky.cube, uReflectionTexture: sky.atlasTexture, uReflectionLookup: sky.lookupTexture };
    return new Map(described.samplers.map(({ name, unit }) => [
      unit, skyTextures[name] ?? (item.material ? item.material.unitTextures.get(unit) : scene.patterns?.get(name)),
    ]));
  }

  /** A copy: the next call of the module writes over its block. The numbers are kept for who draws the same elsewhere. */
  pack(call, block, numbers) {
    this.packed[block] = numbers.flat(Infinity);
    return this.library.copyFloats([this.library.pack(call, numbers), this.blockFloats[block]]);
  }
}

/** The sky's own sun is the first. */
function withSun(own, sky, words) {
  return own?.suns || !sky.sun || !words.has("sh") ? own : { ...own, suns: [sky.sun] };
}

/** The program that shows the sky as these words show surfaces. */
function skyName(words) {
  return ["sky", ...["reinhard", "aces", "neutral", "srgb-fast", "pow22", "linear", "dither"].filter((word) => words.has(word))].join("+");
}
