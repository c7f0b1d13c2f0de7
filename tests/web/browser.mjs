// SPDX-License-Identifier: MIT
// Chromium with the playground, for the tests: SITE and CHROMIUM are in the environment.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { chromium } from "playwright-core";

const { SITE, CHROMIUM, SERVE } = process.env;
const kFlags = ["--no-sandbox", "--disable-gpu-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

/** The server that examples/web/serve.sh starts, on a free port. */
async function startServer() {
  const server = spawn("python3", ["-B", SERVE, SITE, "0"], { stdio: ["ignore", "pipe", "inherit"] });
  const [said] = await Promise.race([once(server.stdout, "data"), once(server, "exit")]);
  const [address] = /http:\S+/.exec(said) ?? [];
  if (!address)
    throw new Error(`the server does not start: ${said}`);
  process.on("exit", () => server.kill());
  return { address, stop: () => server.kill() };
}

/** Multisampling mixes encoded colours along the edges of triangles: left out where pictures are compared. */
export function withoutMultisampling() {
  const get = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, asked) {
    return get.call(this, kind, { ...asked, antialias: false });
  };
}

/** A server on the loopback interface and a browser; close() ends both. */
export async function openBrowser() {
  const server = await startServer();
  const browser = await chromium.launch({ executablePath: CHROMIUM, args: kFlags });

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
    await page.goto(server.address + hash);
    await page.waitForSelector("body[data-ready]", { timeout: 60000 });
    return page;
  }

  return { open, close: async () => { await browser.close(); server.stop(); } };
}

let opened, common;

/** The browser that the tests of one process share, and a page of it; withoutMultisampling() holds for that page. */
const sharedBrowser = () => (opened ??= openBrowser());
export const sharedPage = () => (common ??= sharedBrowser().then(({ open }) => open("", { before: withoutMultisampling })));
export const closeShared = async () => (await opened)?.close();

/** A page of its own, for what happens when it starts. */
export const freshPage = async (hash, options) => (await sharedBrowser()).open(hash, options);

/** Takes a page to the state of an address: what that does not say is as usual. */
export const go = (page, hash) => page.evaluate((hash) => {
  history.replaceState(null, "", location.pathname + hash);
  dispatchEvent(new HashChangeEvent("hashchange"));
}, hash);

export const textOf = (page, id) => page.textContent(`#${id}`);
export const stateOf = (page) => page.evaluate(() => ({ ...playground.state }));
export const skyIsThere = (page) => page.waitForFunction(() => playground.sky.cube, null, { timeout: 120000 });

export const kBackground = [33, 33, 36]; // Of picture.js, as codes.

/** What the canvas shows, from the lowest row up, and its size. */
export async function readPixels(page) {
  const { width, height, text } = await page.evaluate(() => {
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

/** The same of a frame that is drawn for it. */
export async function pixelsOf(page) {
  await page.evaluate(() => playground.draw());
  return readPixels(page);
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
