// SPDX-License-Identifier: MIT
// The page for everyone: what axe finds, light and dark, wide and as on a phone; what it weighs.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { before, test } from "node:test";
import { go, sharedPage } from "./browser.mjs";

const { SITE } = process.env;
const kAxe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let page;
before(async () => { page = await sharedPage(); });

test("the page weighs at most a megabyte without models, and asks nobody else", () => {
  const files = readdirSync(SITE, { recursive: true }).filter((file) => file !== "model.glb" && statSync(`${SITE}/${file}`).isFile());
  const bytes = files.reduce((sum, file) => sum + statSync(`${SITE}/${file}`).size, 0);
  console.log(`${files.length} files, ${bytes} bytes`);
  assert.ok(bytes <= 1e6, `${bytes} bytes`);
  for (const file of files.filter((name) => /\.(html|js|css)$/.test(name)))
    assert.doesNotMatch(readFileSync(`${SITE}/${file}`, "utf8"), /(src|href|import|fetch)[^\n]{0,12}https?:/, file);
});

test("axe finds no violation, wide and light, and dark as on a phone; nothing is wider than the page", async () => {
  await go(page, "#basecolor.normal+sh+sun1");
  await page.click('#presets button[data-preset="000"]');
  await page.evaluate(kAxe);
  for (const [width, colorScheme] of [[1280, "light"], [360, "dark"]]) { // Contrast is a matter of the colours alone.
    await page.setViewportSize({ width, height: 900 });
    await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
    const { violations, passes } = await page.evaluate(() => axe.run());
    assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.length, nodes[0].html]), [], `${width} ${colorScheme}`);
    assert.ok(passes.length > 20);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  }
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
});

test("opened as a file, the page says what it needs", async () => {
  const file = await page.context().newPage();
  await file.goto(`file://${SITE}/index.html`);
  assert.ok(await file.isVisible("#from-file"));
  assert.ok((await file.textContent("#from-file code")).includes(`--directory "${SITE}" 8080`));
  await file.close();
  assert.ok(!await page.isVisible("#from-file"));
});
