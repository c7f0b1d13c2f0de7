// SPDX-License-Identifier: MIT
// Each control of the playground does what it says.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, test } from "node:test";
import { freshPage, go, pixelsOf, sharedPage, stateOf, textOf, withoutMultisampling } from "./browser.mjs";

let page;
before(async () => { page = await sharedPage(); });

test("each option of each choice is in the name, or dropped or refused in words, and the controls show it", async (t) => {
  await go(page, "#basecolor.metalrough.normal.mask+sh+sun2+punctual1");
  const choices = await page.evaluate(() => { // Without pictures, which take most of the time, and have their own tests.
    playground.kept = playground.picture;
    playground.picture = null;
    return playground.described.choices;
  });
  t.after(() => page.evaluate(() => { playground.picture = playground.kept; }));
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
});

/** A program in which each slider counts. */
const kSliders = {
  red: "sun1", green: "sun1", blue: "sun1", alpha: "blend+sun1", metallic: "sun1", roughness: "sun1", exposure: "sun1", lux: "sun1",
  azimuth: "sun1", height: "sun1", ambient: "ambient", normalScale: "normal+sun1", occlusion: "occlusion+ambient",
  glow: "emissive-factor+sun1+reinhard", cutoff: "basecolor.mask+sun1", candela: "punctual1",
};

test("each slider changes the picture and the address", async () => {
  await go(page, "");
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
});

test("an address reproduces the state, and what is typed as a name is taken or refused", async () => {
  await go(page, "#basecolor.normal+ambient+sun1+aces;roughness=0.25;yaw=77;height=12");
  const second = await freshPage(await page.evaluate(() => location.hash), { before: withoutMultisampling });
  assert.ok((await pixelsOf(page)).rgba.equals((await pixelsOf(second)).rgba));
  assert.equal((await stateOf(second)).roughness, 0.25);
  await second.fill("#name", "sun2+normal+reinhard");
  await second.press("#name", "Enter");
  assert.equal((await stateOf(second)).name, "normal+sun2+reinhard");
  await second.fill("#name", "sun2+normel");
  await second.press("#name", "Enter");
  assert.match(await textOf(second, "says"), /normel[^]*normal/);
  assert.equal((await stateOf(second)).name, "normal+sun2+reinhard");
  const third = await freshPage("#no-such-word;roughness=nan;shape=cube;yaw=1e99");
  assert.equal((await stateOf(third)).name, "basecolor.normal+ambient+sun1");
  assert.deepEqual([...page.problems(), ...second.problems(), ...third.problems()], []);
  for (const each of [second, third])
    await each.context().close();
});

test("what is new is marked, each line says where it comes from, and names its paper", async () => {
  await go(page, "#sun1");
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
  await page.focus("#vertex");
  await page.keyboard.press("ArrowDown");
  assert.match(await textOf(page, "origin"), /Line 2:/);
});

test("prices are measured or marked as computed; budgets say what is too much; the ladder ends unlit", async () => {
  await go(page, "#sun1");
  assert.equal(await page.locator("#price td:has-text('measured')").count(), 3);
  await page.evaluate(() => playground.set({ name: "basecolor.normal+ambient+sun1+decode-fast+srgb-fast+dither" }));
  assert.ok(await page.locator("#price td:has-text('computed from the price list')").count() >= 1);
  await page.evaluate(() => playground.set({ name: "basecolor.metalrough.normal.skin4.joints256+sh+sun4" }));
  assert.ok(await page.locator("#budget .over").count() > 0);
  assert.match(await textOf(page, "advice"), /without '/);
  assert.match(await page.textContent("#ladder li:last-child"), /^unlit/);
});

test("shaders are copied and saved as they are, and pictures", async () => {
  await go(page, "#sun1");
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
});

test("keys go round the model, and reach every control", async () => {
  await go(page, "#sun1");
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
});

test("it turns until it is told not to, and not where motion is unwanted", async () => {
  assert.equal(await page.getAttribute("#turning", "aria-pressed"), "false");
  const moving = await freshPage("#sun1", { reducedMotion: "no-preference" });
  const { yaw } = await stateOf(moving);
  await moving.waitForFunction((yaw) => playground.state.yaw > yaw + 1, yaw);
  await moving.click("#turning");
  const stopped = await stateOf(moving);
  await moving.waitForTimeout(200);
  assert.equal((await stateOf(moving)).yaw, stopped.yaw);
  await moving.context().close();
});

test("a pointer goes round the model, the wheel comes closer, and the shape is chosen", async () => {
  await go(page, "#sun1");
  const first = await stateOf(page);
  await page.hover("#picture"); // Which scrolls to it.
  const { x, y, width, height } = await page.locator("#picture").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 50, y + height / 2 + 20, { steps: 5 });
  await page.mouse.up();
  const dragged = await stateOf(page);
  assert.ok(dragged.yaw < first.yaw - 5 && dragged.pitch > first.pitch + 2, JSON.stringify(dragged));
  await page.mouse.move(x + width / 2, y + height / 2); // No button is down.
  assert.equal((await stateOf(page)).yaw, dragged.yaw);
  await page.mouse.wheel(0, -100);
  await page.waitForFunction((distance) => playground.state.distance < distance, first.distance);
  const ball = await pixelsOf(page);
  await page.selectOption("#shape", "model");
  await page.waitForFunction(() => playground.scene()?.materials.length > 1);
  assert.ok(!ball.rgba.equals((await pixelsOf(page)).rgba));
  assert.match(await page.evaluate(() => location.hash), /;shape=model/);
});

/** Each control, and the test that uses it: a new one needs one. */
const kTested = new Set([
  "picture", "turning", "shape", "material", "save-picture", "file", "name", "copy", "save-vertex", "save-fragment", "save-header", "fragment", "vertex",
  ...Object.keys(kSliders).map((key) => `number-${key}`),
]);

test("no control is without a test", async () => {
  const found = await page.$$eval("button, input, select, textarea, a[href], [tabindex]", (controls) => controls
    .filter(({ dataset, className }) => !dataset.choice && !dataset.preset && className !== "scrolls").map(({ id }) => id));
  assert.deepEqual(found.filter((id) => !kTested.has(id)), []);
  assert.equal(found.length, kTested.size);
});
