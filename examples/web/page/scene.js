// SPDX-License-Identifier: MIT
// What is drawn: the page's sphere, or the scene of a file.
import { kRepeated, meshOf, textureOf } from "./driver.js";

const kIdentity3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];
const kIdentity4 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const kRings = 48;

/** A transform of coordinates that is seen: turned a little. */
const kTransformed = [0.95, 0.3, 0, -0.3, 0.95, 0, 0, 0, 1];

function copied(library, arrays) {
  const numbers = {};
  for (const name of ["positions", "normals", "tangents", "uv0", "uv1", "colors"])
    numbers[name] = library.copyFloats(arrays[name]);
  return { numbers, indices: library.copyIndices(arrays.indices) };
}

/** Textures of the page's own material, by the sampler that reads them. */
function patterns(library, roles) {
  return new Map(roles.flatMap(({ sampler, repeats }, role) => {
    if (!repeats)
      return [];
    const { width, height, rgba } = library.texture(role);
    return [[sampler, textureOf({ width, height, rgba: library.copyBytes(rgba) }, kRepeated)]];
  }));
}

export function sphereScene(library, roles) {
  const { numbers, indices } = copied(library, library.sphere(kRings));
  return {
    least: [-1, -1, -1], most: [1, 1, 1], isOwn: true, materials: [], warnings: [],
    items: [{ mesh: meshOf(numbers, indices), world: kIdentity4, mirrored: false, material: null }],
    patterns: patterns(library, roles),
    transforms: [kTransformed, kTransformed],
  };
}

/** WebGL 1 repeats only sizes that are powers of two. */
const powerOfTwo = (size) => 2 ** Math.min(Math.round(Math.log2(size)), 11);

/** What is to be decoded, copied out of the module before anything else is called. */
function encoded(library, { width, height, encoded: [address, size], rgba }) {
  if (size === 0)
    return { width, height, rgba: library.copyBytes(rgba) };
  return { width, height, blob: new Blob([library.copyBytes([address, size])]) };
}

async function decoded({ width, height, rgba, blob }) {
  if (!blob)
    return { width, height, rgba };
  return createImageBitmap(blob, {
    premultiplyAlpha: "none", colorSpaceConversion: "none", resizeQuality: "high",
    resizeWidth: powerOfTwo(width), resizeHeight: powerOfTwo(height),
  });
}

/** Which of the two streams of a program reads which of the file's coordinates. */
function meshFor(numbers, indices, { uvSets }) {
  const streams = [numbers.uv0, numbers.uv1];
  return meshOf({ ...numbers, uv0: streams[uvSets[0]] ?? [], uv1: streams[uvSets[1]] ?? [] }, indices);
}

/** The scene of a .glb; throws the gate's words. */
export async function fileScene(library, name, bytes) {
  const said = library.model(name, bytes);
  const meshes = said.meshes.map((primitives) => primitives.map(({ arrays, plan }) => ({ ...copied(library, arrays), plan })));
  const images = await Promise.all(said.images.map((image) => encoded(library, image)).map(decoded));
  const textures = said.textures.map((texture) => texture.image < 0 ? null : textureOf(images[texture.image], texture));
  const materials = [];
  const items = meshes.map((primitives) => primitives.map(({ numbers, indices, plan }) => {
    const unitTextures = new Map(plan.textures.map((index, unit) => [unit, textures[index]]));
    materials.push({ ...plan, unitTextures });
    return { mesh: meshFor(numbers, indices, plan), material: materials.at(-1) };
  }));
  return {
    least: said.least, most: said.most, isOwn: false, materials, warnings: said.warnings,
    items: said.instances.flatMap(({ mesh, world, mirrored }) => items[mesh].map((item) => ({ ...item, world, mirrored }))),
  };
}

export { kIdentity3, kIdentity4 };
