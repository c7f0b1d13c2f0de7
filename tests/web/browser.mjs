// SPDX-License-Identifier: MIT
// Chromium with the playground, for the tests: SITE and CHROMIUM are in the environment.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";
import { chromium } from "playwright-core";

const { SITE, CHROMIUM } = process.env;
const kTypes = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".gz": "application/gzip", ".json": "application/json" };
const kFlags = ["--no-sandbox", "--disable-gpu-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

async function respond(request, response) {
  const file = new URL(request.url, "http://localhost").pathname.replace(/\/$/, "/index.html");
  try {
    const bytes = await readFile(`${SITE}${file}`);
    response.writeHead(200, { "content-type": kTypes[extname(file)] ?? "application/octet-stream" });
    response.end(bytes);
  } catch {
    response.writeHead(404);
    response.end();
  }
}

/** A server on the loopback interface and a browser; close() ends both. */
export async function openBrowser() {
  const server = createServer(respond);
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const browser = await chromium.launch({ executablePath: CHROMIUM, args: kFlags });
  const address = `http://127.0.0.1:${server.address().port}/`;

  /** A page at that state, ready. Errors of the page are thrown by problems(). */
  async function open(hash = "", { width = 1280, height = 900, before, ...options } = {}) {
    const context = await browser.newContext({
      viewport: { width, height }, reducedMotion: "reduce", acceptDownloads: true,
      permissions: ["clipboard-read", "clipboard-write"], ...options,
    });
    const page = await context.newPage();
    const found = [];
    page.on("pageerror", (error) => found.push(error.message));
    page.problems = () => found;
    if (before)
      await page.addInitScript(before);
    await page.goto(address + hash);
    await page.waitForSelector("body[data-ready]", { timeout: 60000 });
    return page;
  }

  return { open, address, close: async () => { await browser.close(); server.close(); } };
}

/** What the canvas shows, from the lowest row up, and its size. */
export async function pixelsOf(page) {
  const { width, height, text } = await page.evaluate(() => {
    playground.draw();
    const { gl } = playground.picture.driver;
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const bytes = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let text = "";
    for (let i = 0; i < bytes.length; i += 32768)
      text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return { width, height, text: btoa(text) };
  });
  return { width, height, rgba: Buffer.from(text, "base64") };
}

/** Pixels whose neighbours, `rim` away, all differ from the background: inside of what is drawn. */
export function inside({ width, height, rgba }, background, rim = 3) {
  const isDrawn = (x, y) => [0, 1, 2].some((c) => Math.abs(rgba[4 * (y * width + x) + c] - background[c]) > 1);
  const found = [];
  for (let y = rim; y < height - rim; ++y)
    for (let x = rim; x < width - rim; ++x)
      if ([[0, 0], [rim, 0], [-rim, 0], [0, rim], [0, -rim]].every(([dx, dy]) => isDrawn(x + dx, y + dy)))
        found.push(y * width + x);
  return found;
}

/** How two pictures differ there, in 8-bit codes: the mean, the share of channels within one, the most. */
export function difference(a, b, places) {
  let sum = 0, within = 0, most = 0;
  for (const place of places)
    for (let c = 0; c < 3; ++c) {
      const off = Math.abs(a[4 * place + c] - b[4 * place + c]);
      sum += off;
      within += off <= 1;
      most = Math.max(most, off);
    }
  const count = 3 * places.length;
  return { mean: sum / count, withinOne: within / count, most, count };
}
