// SPDX-License-Identifier: MIT
// The playground in Chromium: each control does what it says, and the pictures are OSMesa's.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { after, before, test } from "node:test";
import { difference, inside, openBrowser, pixelsOf } from "./browser.mjs";

const { SITE, BIN } = process.env;
const kWork = mkdtempSync(`${tmpdir()}/frankenshader-web-`);
const kAxe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const kBackground = [33, 33, 36]; // Of picture.js, as codes.

let browser;
before(async () => { browser = await openBrowser(); });
after(() => {
  rmSync(kWork, { recursive: true });
  return browser.close();
});

const textOf = (page, id) => page.textContent(`#${id}`);
const stateOf = (page) => page.evaluate(() => ({ ...playground.state }));
const skyIsThere = (page) => page.waitForFunction(() => playground.sky.cube, null, { timeout: 120000 });

test("the page weighs at most a megabyte without models, and asks nobody else", () => {
  const files = readdirSync(SITE, { recursive: true }).filter((file) => file !== "model.glb" && statSync(`${SITE}/${file}`).isFile());
  const bytes = files.reduce((sum, file) => sum + statSync(`${SITE}/${file}`).size, 0);
  console.log(`${files.length} files, ${bytes} bytes`);
  assert.ok(bytes <= 1e6, `${bytes} bytes`);
  for (const file of files.filter((name) => /\.(html|js|css)$/.test(name)))
    assert.doesNotMatch(readFileSync(`${SITE}/${file}`, "utf8"), /(src|href|import|fetch)[^\n]{0,12}https?:/, file);
});

test("each option of each choice is in the name, or dropped or refused in words, and the controls show it", async () => {
  const page = await browser.open("#basecolor.metalrough.normal.mask+sh+sun2+punctual1");
  const choices = await page.evaluate(() => playground.described.choices);
  const counts = { taken: 0, dropped: 0, refused: 0 };
  for (const [choice, { name, options }] of choices.entries())
    for (const [option, { word }] of options.entries()) {
      const before = await stateOf(page);
      const wasSet = await page.evaluate(([name, choice]) => playground.describe(name).values[choice], [before.name, choice]);
      if (wasSet === option)
        continue;
      await page.selectOption(`select[data-choice="${choice}"]`, word);
      const { name: after } = await stateOf(page);
      const [says, shown, address, typed] = await page.evaluate((choice) => [
        document.getElementById("says").textContent, document.querySelector(`select[data-choice="${choice}"]`).value,
        decodeURIComponent(location.hash), document.getElementById("name").value], choice);
      assert.ok(address.startsWith(`#${after}`) && typed === after, `${name}: ${address}`);
      const values = await page.evaluate((name) => playground.describe(name).values, after);
      assert.equal(shown, options[values[choice]].word, name);
      if (after === before.name && shown !== word) {
        assert.match(says, new RegExp(`${word} was dropped: .+\\.|\\[permutation\\.`), `${name}: ${word}`);
        ++counts[says.includes("[permutation.") ? "refused" : "dropped"];
      } else {
        assert.equal(shown === word || says.includes(`${word} was dropped`), true, `${name}: ${word}: ${says}`);
        ++counts.taken;
      }
      await page.evaluate((state) => playground.set(state), before);
    }
  console.log(`${choices.length} choices: ${JSON.stringify(counts)}`);
  assert.ok(counts.taken > 40 && counts.refused >= 3 && counts.dropped > 1);
  assert.deepEqual(page.problems(), []);
  await page.context().close();
});

/** A program in which each slider counts. */
const kSliders = {
  red: "sun1", green: "sun1", blue: "sun1", alpha: "blend+sun1", metallic: "sun1", roughness: "sun1", exposure: "sun1", lux: "sun1",
  azimuth: "sun1", height: "sun1", ambient: "ambient", normalScale: "normal+sun1", occlusion: "occlusion+ambient",
  glow: "emissive-factor+sun1+reinhard", cutoff: "basecolor.mask+sun1", candela: "punctual1",
};

test("each slider changes the picture and the address", async () => {
  const page = await browser.open();
  const usual = await stateOf(page);
  for (const [key, name] of Object.entries(kSliders)) {
    await page.evaluate((state) => playground.set(state), { ...usual, name });
    const before = await pixelsOf(page);
    const value = await page.evaluate((key) => {
      const slider = document.getElementById(`number-${key}`);
      slider.value = Number(slider.value) > (Number(slider.min) + Number(slider.max)) / 2 ? slider.min : slider.max;
      slider.dispatchEvent(new Event("input"));
      return Number(slider.value);
    }, key);
    assert.ok(!before.rgba.equals((await pixelsOf(page)).rgba), key);
    assert.match(await page.evaluate(() => location.hash), new RegExp(`;${key}=${value}`.replaceAll(".", "\\.")));
  }
  assert.equal(Object.keys(kSliders).length, await page.locator("#numbers input").count());
  await page.context().close();
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

/** Multisampling mixes encoded colours along the edges of triangles: left out, as everywhere. */
function withoutMultisampling() {
  const get = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, asked) {
    return get.call(this, kind, { ...asked, antialias: false });
  };
}

test("pictures are OSMesa's", async () => {
  // From the side: at the poles all of a texture's width meets in a point, and renderers choose levels as they like.
  const page = await browser.open("#sh+sun1;pitch=0", { before: withoutMultisampling });
  await skyIsThere(page);
  await page.evaluate(() => { delete playground.sky.cube; }); // Nothing behind the sphere.
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
  await page.context().close();
});

test("presets set their program, say what was mapped, and draw", async () => {
  const page = await browser.open();
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
  await page.context().close();
});

test("an address reproduces the state, and what is typed as a name is taken or refused", async () => {
  const first = await browser.open("#basecolor.normal+ambient+sun1+aces;roughness=0.25;yaw=77;height=12");
  const second = await browser.open(`#${await first.evaluate(() => location.hash.slice(1))}`);
  assert.ok((await pixelsOf(first)).rgba.equals((await pixelsOf(second)).rgba));
  assert.equal((await stateOf(second)).roughness, 0.25);
  await second.fill("#name", "sun2+normal+reinhard");
  await second.press("#name", "Enter");
  assert.equal((await stateOf(second)).name, "normal+sun2+reinhard");
  await second.fill("#name", "sun2+normel");
  await second.press("#name", "Enter");
  assert.match(await textOf(second, "says"), /normel[^]*normal/);
  assert.equal((await stateOf(second)).name, "normal+sun2+reinhard");
  const third = await browser.open("#no-such-word;roughness=nan;shape=cube;yaw=1e99");
  assert.equal((await stateOf(third)).name, "basecolor.normal+ambient+sun1");
  assert.deepEqual([...first.problems(), ...second.problems(), ...third.problems()], []);
  for (const page of [first, second, third])
    await page.context().close();
});

test("what is new is marked, each line says where it comes from, and names its paper", async () => {
  const page = await browser.open("#sun1");
  await page.selectOption('select[data-choice]:has(option[value="aces"])', "aces");
  const marked = await page.$$eval("#fragment .new", (items) => items.map(({ textContent }) => textContent));
  assert.ok(marked.some((line) => line.includes("aces") || line.includes("2.51")), marked.join("\n"));
  assert.ok(marked.length < 12);
  assert.ok(await page.locator("#fragment .type").count() > 20 && await page.locator("#fragment .comment").count() > 5);
  const line = await page.$$eval("#fragment li", (items) => items.findIndex(({ textContent }) => textContent.includes("2.51")));
  await page.hover(`#fragment li:nth-child(${line + 1})`);
  await page.waitForSelector("#origin pre");
  assert.match(await textOf(page, "origin"), /generator\/glsl\/fragment\/output\/tone_aces\.glsl:\d+, because of sun1\+aces[^]*Narkowicz/);
  await page.focus("#fragment");
  await page.keyboard.press("ArrowUp");
  assert.match(await textOf(page, "origin"), new RegExp(`Line ${line}:`));
  await page.context().close();
});

test("prices are measured or marked as computed; budgets say what is too much; the ladder ends unlit", async () => {
  const page = await browser.open("#sun1");
  assert.equal(await page.locator("#price td:has-text('measured')").count(), 3);
  await page.evaluate(() => playground.set({ name: "basecolor.normal+ambient+sun1+decode-fast+srgb-fast+dither" }));
  assert.ok(await page.locator("#price td:has-text('computed from the price list')").count() >= 1);
  await page.evaluate(() => playground.set({ name: "basecolor.metalrough.normal.skin4.joints256+sh+sun4" }));
  assert.ok(await page.locator("#budget .over").count() > 0);
  assert.match(await textOf(page, "advice"), /without '/);
  assert.match(await page.textContent("#ladder li:last-child"), /^unlit/);
  await page.context().close();
});

test("shaders are copied and saved as they are, and pictures", async () => {
  const page = await browser.open("#sun1");
  const texts = await page.evaluate(() => ["vertex", "fragment"].map((stage) => playground.describe("sun1")[stage].text));
  await page.click("#copy");
  await page.waitForFunction(() => document.getElementById("copied").textContent);
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), texts.join("\n"));
  for (const [button, file, content] of [["save-vertex", "sun1.vert", texts[0]], ["save-fragment", "sun1.frag", texts[1]], ["save-header", "shaders.h", null], ["save-picture", "sun1.png", null]]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${button}`)]);
    assert.equal(download.suggestedFilename(), file);
    const bytes = readFileSync(await download.path());
    if (content)
      assert.equal(bytes.toString(), content);
    else
      assert.ok(file === "sun1.png" ? bytes.subarray(1, 4).toString() === "PNG" : bytes.includes("franken_sun1_fragment"));
  }
  await page.context().close();
});

const give = (page, name, buffer) => page.setInputFiles("#file", { name, mimeType: "application/octet-stream", buffer });
const says = (page, pattern) => page.waitForFunction((text) => new RegExp(text).test(document.getElementById("file-says").textContent), pattern.source, { timeout: 120000 });

test("files: a model is drawn, a sky lights, and what is broken is refused in the gate's words", async () => {
  const page = await browser.open("#ambient+sun1");
  const glb = readFileSync(`${SITE}/model.glb`);
  await give(page, "cut.glb", glb.subarray(0, 5000));
  await says(page, /cut\.glb: .*\[gltf\.container\]/);
  await give(page, "broken.hdr", Buffer.from("#?RADIANCE\n\n-Y 4 +X 4\nxx"));
  await says(page, /\[hdr\.format\]/);
  await give(page, "urn.glb", glb);
  await page.waitForFunction(() => playground.state.shape === "file");
  const model = await pixelsOf(page);
  assert.ok(inside(model, kBackground).length > 10000);
  assert.ok(await page.locator("#material option").count() > 2);
  assert.ok(await page.locator("select[data-choice]:disabled").count() > 10);
  await give(page, "lake.hdr", readFileSync(`${SITE}/evening.hdr`));
  await says(page, /lake\.hdr is the sky/);
  await page.evaluate(() => playground.set({ name: "sh+reflection+sun1" }));
  assert.ok(!model.rgba.equals((await pixelsOf(page)).rgba));
  assert.deepEqual(page.problems(), []);
  await page.context().close();
});

test("a lost context comes back with the same picture", async () => {
  const page = await browser.open("#basecolor.normal+ambient+sun1");
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
  await page.context().close();
});

test("without WebGL, texts, budgets and prices are there, and the page says what is missing", async () => {
  const page = await browser.open("#sun1", { before: () => { HTMLCanvasElement.prototype.getContext = () => null; } });
  assert.match(await textOf(page, "picture-says"), /no WebGL/);
  assert.ok(await page.locator("#fragment li").count() > 30);
  assert.ok(await page.locator("#price td").count() > 5);
  await page.context().close();
});

test("axe finds no violation: wide and as on a phone, light and dark; nothing is wider than the page", async () => {
  for (const [width, colorScheme] of [[1280, "light"], [1280, "dark"], [360, "light"], [360, "dark"]]) {
    const page = await browser.open("#basecolor.normal+sh+sun1", { width, colorScheme });
    await page.click('#presets button[data-preset="000"]');
    await page.evaluate(kAxe);
    const { violations, passes } = await page.evaluate(() => axe.run());
    assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.length, nodes[0].html]), [], `${width} ${colorScheme}`);
    assert.ok(passes.length > 20);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    await page.context().close();
  }
});

test("keys go round the model, and reach every control", async () => {
  const page = await browser.open("#sun1");
  await page.focus("#picture");
  const first = await stateOf(page);
  for (const key of ["ArrowRight", "ArrowUp", "+"])
    await page.keyboard.press(key);
  const now = await stateOf(page);
  assert.ok(now.yaw === first.yaw + 5 && now.pitch === first.pitch + 5 && now.distance < first.distance);
  const reached = new Set();
  for (let i = 0; i < 90; ++i) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.dataset.choice || document.activeElement.dataset.preset));
  }
  for (const id of ["turning", "shape", "file", "name", "copy", "save-header", "fragment", "vertex", "number-red", "000", "33"])
    assert.ok(reached.has(id), id);
  await page.context().close();
});

test("it turns until it is told not to, and not where motion is unwanted", async () => {
  const still = await browser.open("#sun1");
  assert.equal(await still.getAttribute("#turning", "aria-pressed"), "false");
  const page = await browser.open("#sun1", { reducedMotion: "no-preference" });
  const { yaw } = await stateOf(page);
  await page.waitForFunction((yaw) => playground.state.yaw > yaw + 1, yaw);
  await page.click("#turning");
  const stopped = await stateOf(page);
  await page.waitForTimeout(200);
  assert.equal((await stateOf(page)).yaw, stopped.yaw);
  for (const each of [still, page])
    await each.context().close();
});

test("ANGLE compiles and links all covering programs", async () => {
  const page = await browser.open("#sun1");
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
  await page.context().close();
});
