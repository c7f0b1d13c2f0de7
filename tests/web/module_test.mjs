// SPDX-License-Identifier: MIT
// The module without a browser: the same bytes as the native program, the library's words, its gate. In the environment:
// SITE, the built playground, and BIN, where frankenshader is.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";

const { SITE, BIN } = process.env;
const { Library, Refusal } = await import(`${SITE}/module.js`);
const { Prices } = await import(`${SITE}/price.js`);
const library = await Library.load(gunzipSync(readFileSync(`${SITE}/playground.wasm.gz`)));
const described = library.describe();
const native = (...parameters) => execFileSync(`${BIN}/frankenshader`, parameters, { encoding: "utf8", maxBuffer: 1 << 28 });

const indexOf = (choice) => described.choices.findIndex(({ name }) => name === choice);
const wordsOf = ({ values }) => new Set(values.map((value, i) => described.choices[i].options[value].word));

test("choices are those of the program", () => {
  const { choices } = JSON.parse(native("list", "--words", "--json"));
  assert.deepEqual(described.choices.map(({ name, options }) => ({ name, options })), choices);
});

test("all covering programs have the native program's bytes", () => {
  const { programs } = JSON.parse(native("dump", "--covering", "--format", "json"));
  assert.deepEqual(library.covering(), programs.map(({ name }) => name));
  assert.ok(programs.length > 400);
  for (const program of programs) {
    const own = library.program(program.name);
    assert.equal(own.vertex.text, program.vertex, program.name);
    assert.equal(own.fragment.text, program.fragment, program.name);
    assert.equal(own.key, program.key);
    assert.deepEqual(own.lint, [], program.name);
    const offsets = (list) => list.map(({ name, offset }) => [name, offset]);
    assert.deepEqual(offsets(own.uniforms), offsets(program.interface.uniforms), program.name);
    assert.equal(own.vertex.lines.length, own.vertex.text.split("\n").length - 1);
  }
});

test("a header of C is the native program's", () => {
  const name = "basecolor.normal+ambient+sun1";
  assert.equal(library.header(name), native("dump", name, "--format", "c"));
});

test("contradictions are refused, and what changes nothing is dropped, in the composer's words", () => {
  assert.throws(() => library.choose("sun1", indexOf("occlusion"), 2), (error) => {
    assert.ok(error instanceof Refusal);
    assert.match(error.message, /occlusion-packed: there is no packed metallic-roughness texture/);
    return true;
  });
  const { name, dropped } = library.choose("sun1", indexOf("occlusion"), 1);
  assert.equal(name, "sun1");
  assert.equal(dropped[0].word, "occlusion");
  assert.equal(dropped[0].reason, "no line of this program depends on it");
  assert.throws(() => library.program("basecolour+sun1"), /basecolor/);
  assert.equal(library.choose("sun1", indexOf("baseColorTexture"), 1).name, "basecolor+sun1");
});

test("budgets and ladders are the native program's", () => {
  const name = "basecolor.metalrough.normal.occlusion.emissive+sh+reflection+sun4+punctual4";
  const { budgets, ladder } = library.program(name);
  const explained = JSON.parse(native("explain", name, "--json"));
  for (const [i, { profile, uses, fits }] of budgets.entries()) {
    assert.equal(profile, explained.budgets[i].profile);
    assert.equal(fits, explained.budgets[i].fits);
    for (const { resource, used, limit } of uses)
      assert.deepEqual({ used, limit }, { used: explained.budgets[i][resource].used, limit: explained.budgets[i][resource].limit });
  }
  assert.equal(ladder.at(-1), "unlit");
  assert.ok(ladder.length > 4 && ladder.length <= 11);
});

test("broken files are refused in the gate's words, and the module goes on", () => {
  const glb = readFileSync(`${SITE}/model.glb`);
  assert.throws(() => library.model("cut.glb", glb.subarray(0, 1000)), /cut\.glb: .*\[gltf\.container\]/);
  assert.throws(() => library.model("text.glb", new TextEncoder().encode("{]")), /\[gltf\.json\]/);
  assert.throws(() => library.sky(new TextEncoder().encode("#?RADIANCE\n\n-Y 4 +X nine\n"), 0), /\[hdr\.(format|size)\]/);
  assert.throws(() => library.sky(new Uint8Array(0), 0), Refusal);
  const scene = library.model("model.glb", glb);
  assert.ok(scene.instances.length > 0);
  assert.deepEqual(scene.warnings, []);
});

test("a model cut at any of 200 places never traps", () => {
  const glb = readFileSync(`${SITE}/model.glb`);
  for (let i = 0; i < 200; ++i)
    assert.throws(() => library.model("cut.glb", glb.subarray(0, Math.floor(glb.length * i / 200))), Refusal);
});

test("every feature that a price is computed from is in the price list", () => {
  const read = (file) => readFileSync(`${SITE}/${file}`, "utf8");
  const prices = new Prices(read("costs.tsv"), read("prices.md"));
  for (const name of library.covering()) {
    const words = wordsOf(library.program(name));
    for (const { fragment, measured } of prices.of(name, words))
      assert.ok(measured || fragment === undefined || fragment > -40 && Number.isFinite(fragment), name);
  }
  const measured = prices.of("sun1", wordsOf(library.program("sun1")));
  assert.deepEqual(measured.map((price) => price.measured), [true, true, true]);
  assert.equal(measured[0].fragment, Number(/^vc4\tsun1\tok\t(\d+)/m.exec(read("costs.tsv"))[1]));
  const base = "basecolor.normal+ambient+sun1+decode-fast+srgb-fast";
  const [computed] = prices.of(`${base}+reinhard`, wordsOf(library.program(`${base}+reinhard`)));
  assert.equal(computed.fragment, prices.base[0].fragment + prices.list.get("tone map: Reinhard")[0].fragment);
});
