// SPDX-License-Identifier: MIT
// Files that a person gives to the playground, by the dialogue and by dropping them on the page.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { after, before, test } from "node:test";
import { go, inside, kBackground, pixelsOf, sharedPage, textOf } from "./browser.mjs";

const { SITE } = process.env;
const kWork = mkdtempSync(`${tmpdir()}/frankenshader-web-`);
let page;
before(async () => { page = await sharedPage(); });

after(() => rmSync(kWork, { recursive: true }));

const fileOf = (name, bytes) => {
  writeFileSync(`${kWork}/${name}`, bytes);
  return `${kWork}/${name}`;
};
const glb = () => readFileSync(`${SITE}/model.glb`);

/** A Radiance file of one colour. */
const skyOf = (rgbe, width = 16, height = 8) => Buffer.concat([
  Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`),
  Buffer.concat(Array(width * height).fill(Buffer.from(rgbe))),
]);

/** Drags a file of the disk over the page and drops it, as the browser tells a page of what a person does. */
async function drop(file) {
  const devtools = await page.context().newCDPSession(page);
  const data = { items: [], files: [file], dragOperationsMask: 1 };
  const marked = [];
  for (const type of ["dragEnter", "dragOver", "drop"]) {
    await devtools.send("Input.dispatchDragEvent", { type, x: 300, y: 300, data });
    marked.push(await page.evaluate(() => document.body.classList.contains("dropping")));
  }
  await devtools.detach();
  assert.deepEqual(marked.slice(1), [true, false], "where a file may be dropped, the page shows it");
}

/** What the page says of a file, once it says that. */
async function saysOfFile(pattern) {
  await page.waitForFunction((text) => new RegExp(text).test(document.getElementById("file-says").textContent), pattern.source, { timeout: 120000 });
  return page.evaluate(() => document.getElementById("file-says").classList.contains("refused"));
}

const kBroken = [
  ["cut.glb", () => glb().subarray(0, 5000), /cut\.glb: .*\[gltf\.container\]/],
  ["text.glb", () => "{]", /text\.glb: .*\[gltf\.json\]/],
  ["picture.png", () => "\x89PNG", /picture\.png: .*\[gltf\./],
  ["empty.glb", () => "", /empty\.glb: /],
  ["cut.hdr", () => "#?RADIANCE\n\n-Y 4 +X 4\nxx", /\[hdr\.format\]/],
  ["huge.hdr", () => "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999 +X 199998\n", /\[hdr\./],
];

test("a model and a sky that are dropped on the page are drawn; what is broken is refused in the gate's words", async () => {
  await go(page, "#ambient+sun1");
  const ball = await pixelsOf(page);
  for (const [name, bytes, words] of kBroken) {
    await drop(fileOf(name, bytes()));
    assert.ok(await saysOfFile(words), name);
    assert.ok(ball.rgba.equals((await pixelsOf(page)).rgba), `${name}: what was there stays`);
  }
  await drop(fileOf("urn.glb", glb()));
  await page.waitForFunction(() => playground.state.shape === "file");
  assert.equal(await textOf(page, "file-says"), "");
  assert.ok(inside(await pixelsOf(page), kBackground).length > 10000);
  assert.ok(await page.locator("#material option").count() > 2);
  assert.ok(await page.locator("select[data-choice]:disabled").count() > 10);
  await drop(fileOf("blue.hdr", skyOf([16, 16, 128, 129])));
  assert.equal(await saysOfFile(/blue\.hdr is the sky/), false);
  await page.evaluate(() => playground.set({ name: "sh+reflection+sun1" }));
  const { rgba } = await pixelsOf(page);
  for (const [channel, code] of [99, 99, 255].entries()) // (0.125, 0.125, 1), encoded: the sky behind the model.
    assert.ok(Math.abs(rgba[channel] - code) <= 1, `${rgba.subarray(0, 3)}`);
  assert.deepEqual(page.problems(), []);
});

test("the dialogue takes the same files", async () => {
  await go(page, "#ambient+sun1");
  const [name, bytes, words] = kBroken[0];
  await page.setInputFiles("#file", fileOf(name, bytes()));
  assert.ok(await saysOfFile(words));
  await page.setInputFiles("#file", fileOf("vase.glb", glb()));
  await page.waitForFunction(() => playground.state.shape === "file");
  assert.equal(await textOf(page, "file-says"), "");
});

test("the materials of a model are chosen, and its program is shown", async () => {
  await go(page, "#ambient+sun1;shape=model");
  await page.waitForFunction(() => playground.scene()?.materials.length > 1);
  const names = [];
  for (const { index } of await page.$$eval("#material option", (options) => options.map((_, index) => ({ index })))) {
    await page.selectOption("#material", { index });
    names.push(await page.evaluate(() => playground.shownProgram().name));
    assert.ok((await page.textContent("#fragment")).includes(`FrankenShader ${names.at(-1)}`));
  }
  assert.ok(new Set(names).size > 1, names.join(", "));
});
