// SPDX-License-Identifier: MIT
// What the playground draws is what OSMesa draws; ANGLE takes the covering programs; a lost context comes back.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { after, before, test } from "node:test";
import { difference, freshPage, go, inside, kBackground, pixelsOf, sharedPage, skyIsThere, stateOf, textOf } from "./browser.mjs";

const { BIN } = process.env;
const kWork = mkdtempSync(`${tmpdir()}/frankenshader-web-`);

let page;
before(async () => { page = await sharedPage(); });

after(() => rmSync(kWork, { recursive: true }));

test("presets set their program, say what was mapped, and draw", async () => {
  await go(page, "");
  for (const key of await page.$$eval("#presets button", (buttons) => buttons.map((button) => button.dataset.preset))) {
    await page.click(`#presets button[data-preset="${key}"]`);
    const { name, preset } = await stateOf(page);
    assert.equal(preset, key);
    assert.ok((await textOf(page, "preset-says")).length > 80);
    if (name.includes("sh"))
      await skyIsThere(page);
    const picture = await pixelsOf(page);
    assert.ok(inside(picture, kBackground).length > 20000, key);
    assert.equal(await textOf(page, "says"), "");
    assert.equal(await textOf(page, "picture-says"), "");
  }
});

const kCompared = [
  "sun1", "basecolor+sun1", "basecolor.normal+ambient+sun1", "basecolor.metalrough.normal.occlusion-packed.emissive+ambient+sun2",
  "basecolor.metalrough-separate.normal+ambient+sun1+seed", "vertexcolor+sun4+fast+reinhard+pow22", "ambient+punctual3+fast+reinhard+pow22",
  "basecolor.normal+punctual4+spots+aces", "basecolor.mask+ambient+sun1+schlick", "basecolor.unlit+srgb-fast",
  "basecolor.uv0-transform+sun1+decode-fast+srgb-fast", "basecolor.basecolor-uv1+ambient+sun1+neutral", "sun2+vertexlight+dither",
  "basecolor.normal+ambient+sun1+vc4", "basecolor.normal+sh+sun1", "basecolor.metalrough+sh+reflection+sun1+neutral",
];

/** The same picture by Mesa's rasteriser, from the numbers that the page packed. */
async function reference(page, name, size) {
  const job = await page.evaluate(() => ({ ...playground.picture.packed }));
  const textures = {};
  for (const [sampler, key] of [["uReflectionTexture", "atlas"], ["uReflectionLookup", "lookup"]]) {
    const image = await page.evaluate((key) => {
      const image = playground.sky[key];
      if (!image)
        return null;
      let text = "";
      for (let i = 0; i < image.rgba.length; i += 32768)
        text += String.fromCharCode(...image.rgba.subarray(i, i + 32768));
      return { width: image.width, height: image.height, text: btoa(text) };
    }, key);
    if (!image || !name.includes("reflection"))
      continue;
    const file = `${kWork}/${sampler}.rgba`;
    writeFileSync(file, Buffer.from(image.text, "base64"));
    textures[sampler] = { file, width: image.width, height: image.height };
  }
  const background = kBackground.map((code) => code / 255);
  writeFileSync(`${kWork}/job.json`, JSON.stringify({ name, ...size, background, textures, ...job }));
  execFileSync(`${BIN}/web_reference`, [`${kWork}/job.json`, `${kWork}/out.rgba`]);
  return readFileSync(`${kWork}/out.rgba`);
}

test("pictures are OSMesa's", async () => {
  // From the side: at the poles all of a texture's width meets in a point, and renderers choose levels as they like.
  await go(page, "#sh+sun1;pitch=0");
  await skyIsThere(page);
  await page.evaluate(() => { // Nothing behind the sphere.
    playground.keptCube = playground.sky.cube;
    delete playground.sky.cube;
  });
  for (const name of kCompared) {
    await page.evaluate((name) => playground.set({ name }), name);
    assert.equal((await stateOf(page)).name, name);
    const own = await pixelsOf(page);
    const other = await reference(page, name, { width: own.width, height: own.height });
    const places = inside({ ...own, rgba: other }, kBackground);
    const { mean, withinOne, most, count } = difference(own.rgba, other, places);
    console.log(`${name}: mean ${mean.toFixed(4)}, ${(100 * withinOne).toFixed(3)} % within 1, most ${most}`);
    assert.ok(count > 60000, `${name}: ${count}`);
    assert.ok(mean <= 0.25 && withinOne >= 0.999 && most <= 4, name);
  }
  await page.evaluate(() => { playground.sky.cube = playground.keptCube; });
});

test("a lost context comes back with the same picture: programs, a model with its textures, a sky", async () => {
  await go(page, "#sh+reflection+sun1;shape=model");
  await skyIsThere(page);
  await page.waitForFunction(() => playground.scene()?.materials.length > 1);
  const before = await pixelsOf(page);
  await page.evaluate(async () => {
    const lose = playground.picture.driver.gl.getExtension("WEBGL_lose_context");
    const canvas = document.getElementById("picture");
    const comes = (event) => new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }));
    const lost = comes("webglcontextlost");
    lose.loseContext();
    await lost;
    playground.draw();
    const restored = comes("webglcontextrestored");
    setTimeout(() => lose.restoreContext(), 50);
    await restored;
  });
  assert.ok(before.rgba.equals((await pixelsOf(page)).rgba));
  assert.equal(await textOf(page, "picture-says"), "");
});

test("without WebGL, texts, budgets and prices are there, and the page says what is missing", async () => {
  const dark = await freshPage("#sun1", { before: () => { HTMLCanvasElement.prototype.getContext = () => null; } });
  assert.match(await textOf(dark, "picture-says"), /no WebGL/);
  assert.ok(await dark.locator("#fragment li").count() > 30);
  assert.ok(await dark.locator("#price td").count() > 5);
  await dark.context().close();
});

test("ANGLE compiles and links all covering programs", async () => {
  await go(page, "#sun1");
  const { linked, refused } = await page.evaluate(() => {
    const refused = [];
    const names = playground.library.covering();
    for (const name of names)
      try {
        playground.picture.driver.program(playground.describe(name));
      } catch (error) {
        refused.push(error.message);
      }
    return { linked: names.length - refused.length, refused };
  });
  console.log(`ANGLE: ${linked} of ${linked + refused.length} covering programs`);
  assert.deepEqual(refused, []);
  assert.ok(linked > 400);
});
