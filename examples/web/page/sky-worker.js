// SPDX-License-Identifier: MIT
// Filters a sky beside the page, which goes on meanwhile. In: the module and the sky's bytes. Out: {sky} or {error}.
import { Library } from "./module.js";
import { copiedSky } from "./sky.js";

const kFaceSize = 256; // Texels of the skybox.

onmessage = async ({ data: { module, bytes } }) => {
  try {
    const library = await Library.from(module);
    postMessage({ sky: copiedSky(library, library.sky(bytes, kFaceSize)) });
  } catch (error) {
    postMessage({ error: error.message });
  }
};
