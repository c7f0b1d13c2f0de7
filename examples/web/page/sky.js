// SPDX-License-Identifier: MIT
// The sky as light and as picture. The library filters it in a worker: it takes seconds.
import { cubeOf, kClamped, textureOf } from "./driver.js";

/** A sky's pictures, out of the module's memory. */
export function copiedSky(library, said) {
  const copy = (image) => ({ ...image, rgba: library.copyBytes(image.rgba) });
  return { ...said, faces: said.faces.map(copy), atlas: copy(said.atlas), lookup: copy(said.lookup) };
}

/** What the library made of a sky, ready to be drawn with; throws its words. */
export function filterSky(module, bytes) {
  const worker = new Worker(new URL("sky-worker.js", import.meta.url), { type: "module" });
  return new Promise((resolve, reject) => {
    worker.onmessage = ({ data: { sky, error } }) => {
      worker.terminate();
      if (error)
        reject(new Error(error));
      else
        resolve({
          ...sky, // The pictures among it, for who draws the same elsewhere.
          cube: sky.faces[0].width > 0 ? cubeOf(sky.faces) : undefined,
          atlasTexture: textureOf(sky.atlas, kClamped),
          lookupTexture: textureOf(sky.lookup, kClamped),
        });
    };
    worker.postMessage({ module, bytes });
  });
}

/** Before there is one: dark. */
export const kNoSky = { coefficients: Array(27).fill(0), skyRange: 1, reflectionRange: 1 };
