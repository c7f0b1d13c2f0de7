// SPDX-License-Identifier: MIT
// One case: ?engine=ENGINE[-FLAVOUR]&lights=N&extensions=SET. Draws it, and posts what was linked and seen.
import { programOfDraw, watch } from './watch.js';
import { makeScene } from './scene.js';

async function run() {
  const query = new URLSearchParams(location.search);
  const scene = makeScene(Number(query.get('lights')));
  watch(query.get('extensions'), scene.indices.length);
  const [name, flavour] = query.get('engine').split('-');
  const engine = await import(`./${name}.js`);
  const canvas = document.getElementById('canvas');
  await engine.draw(canvas, scene, flavour);
  return { version: engine.version, ...programOfDraw(), picture: canvas.toDataURL('image/png') };
}

const result = await run().catch((error) => ({ error: String(error.stack ?? error) }));
const reply = await fetch(`/result${location.search}`, { method: 'POST', body: JSON.stringify(result) });
const next = await reply.text();
if (next) location.assign(next);
