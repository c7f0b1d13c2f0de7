// SPDX-License-Identifier: MIT
// ANGLE compiles and links every program of the population: tests/web/run.sh population, by hand.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { openBrowser } from "./browser.mjs";

const kBatch = 100; // Programs a page: ANGLE keeps each.

test("ANGLE compiles and links the population", async () => {
  const names = execFileSync(`${process.env.BIN}/web_population`, { encoding: "utf8" }).trim().split("\n");
  const browser = await openBrowser();
  const refused = [];
  for (let at = 0; at < names.length; at += kBatch) {
    const page = await browser.open("#sun1");
    refused.push(...await page.evaluate((names) => names.flatMap((name) => {
      try {
        playground.picture.driver.program(playground.describe(name));
        return [];
      } catch (error) {
        return [error.message];
      }
    }), names.slice(at, at + kBatch)));
    await page.context().close();
  }
  await browser.close();
  console.log(`ANGLE: ${names.length - refused.length} of ${names.length} programs of the population`);
  assert.deepEqual(refused, []);
  assert.ok(names.length > 2500);
});
