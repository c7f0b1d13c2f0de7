// SPDX-License-Identifier: MIT
// What every engine is asked to draw: a unit sphere with tangents, two textures, one material, N suns, a camera.
// +Y up, right-handed; a sun's direction is where its light travels. Colours are linear, the base-colour picture is sRGB.

const kColumns = 64;
const kRows = 32;

function makeSphere() {
  const positions = [], normals = [], tangents = [], uvs = [], indices = [];
  for (let row = 0; row <= kRows; row++) {
    for (let column = 0; column <= kColumns; column++) {
      const u = column / kColumns, v = row / kRows;
      const longitude = 2 * Math.PI * u, polar = Math.PI * v;
      const point = [Math.sin(polar) * Math.sin(longitude), Math.cos(polar), Math.sin(polar) * Math.cos(longitude)];
      positions.push(...point);
      normals.push(...point);
      tangents.push(Math.cos(longitude), 0, -Math.sin(longitude), 1);
      uvs.push(u, 1 - v);
    }
  }
  for (let row = 0; row < kRows; row++) {
    for (let column = 0; column < kColumns; column++) {
      const a = row * (kColumns + 1) + column, b = a + kColumns + 1;
      indices.push(a, b, a + 1, a + 1, b, b + 1);
    }
  }
  return { positions, normals, tangents, uvs, indices };
}

function paint(colourOf) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d');
  for (let y = 0; y < 64; y++) {
    for (let x = 0; x < 64; x++) {
      context.fillStyle = `rgb(${colourOf(x, y).map(Math.round).join(',')})`;
      context.fillRect(x, y, 1, 1);
    }
  }
  return canvas;
}

const chequer = (x, y) => ((x >> 3) + (y >> 3)) % 2 ? [230, 120, 60] : [90, 140, 210];

function ripple(x, y) {
  const n = [0.3 * Math.sin(x * Math.PI / 8), 0.3 * Math.sin(y * Math.PI / 8), 1];
  const length = Math.hypot(...n);
  return n.map((c) => 127.5 + 127.5 * c / length);
}

const kSuns = [
  { direction: [-1, -1, -2], colour: [1.0, 1.0, 1.0] },
  { direction: [2, 0, -1], colour: [0.6, 0.2, 0.1] },
  { direction: [0, 2, -1], colour: [0.1, 0.4, 0.2] },
  { direction: [-2, 1, 0], colour: [0.1, 0.2, 0.6] },
];

export function makeScene(lights) {
  return {
    ...makeSphere(),
    baseColour: paint(chequer),
    normalMap: paint(ripple),
    metallic: 0.25,
    roughness: 0.45,
    ambient: [0.06, 0.06, 0.08],
    suns: kSuns.slice(0, lights),
    camera: { distance: 3, fieldOfView: 45, near: 0.1, far: 10 },
  };
}
