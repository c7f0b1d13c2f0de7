// SPDX-License-Identifier: MIT
// node capture.mjs MODULES OUT: has headless Chromium draw the scene of page/ with each engine in WebGL 1, and writes to OUT
// the program that drew it: ENGINE_sLIGHTS_EXTENSIONS.{vert,frag,png}, and captures.tsv with what became of each case.
// MODULES is the node_modules folder that holds three, babylonjs and playcanvas; CHROMIUM names another browser.
import { spawn } from 'node:child_process';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const kPage = fileURLToPath(new URL('page/', import.meta.url));
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript' };
const kPatience = 60_000;  // milliseconds for one case: a program is compiled and drawn in software
const kChromiumFlags = [
  '--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync', '--remote-debugging-port=0',
];

const [modules, out] = process.argv.slice(2);
if (!out) {
  console.error('usage: node capture.mjs MODULES OUT');
  process.exit(2);
}

const cases = [];
for (const engine of ['three', 'babylon', 'babylon-lean', 'playcanvas', 'playcanvas-ggx'])
  for (const extensions of ['all', 'vc4', 'vc4-flat'])
    for (const lights of [1, 4]) cases.push({ engine, lights, extensions });

const addressOf = (one) => `/?${new URLSearchParams(one)}`;
const rows = [['engine', 'version', 'lights', 'extensions', 'name', 'linked']];
let finish;
const finished = new Promise((resolve) => { finish = resolve; });
let timer;

function expect(one) {
  clearTimeout(timer);
  timer = setTimeout(() => finish(new Error(`no answer from ${addressOf(one)}`)), kPatience);
}

async function keep({ engine, lights, extensions }, result) {
  const name = `${engine}_s${lights}_${extensions}`;
  if (result.error) throw new Error(`${name}: ${result.error}`);
  await writeFile(join(out, `${name}.vert`), result.vertex);
  await writeFile(join(out, `${name}.frag`), result.fragment);
  await writeFile(join(out, `${name}.png`), Buffer.from(result.picture.split(',')[1], 'base64'));
  rows.push([engine, result.version, lights, extensions, name, result.linked ? 'yes' : 'no']);
  console.error(rows.at(-1).join(' '));
}

async function receive(request, response) {
  let body = '';
  for await (const piece of request) body += piece;
  await keep(cases.shift(), JSON.parse(body));
  response.end(cases.length ? addressOf(cases[0]) : '');
  if (cases.length) expect(cases[0]);
  else finish();
}

async function send(path, response) {
  const local = normalize(path === '/' ? '/index.html' : path);
  const file = local.startsWith('/npm/') ? join(modules, local.slice(5)) : join(kPage, local);
  const bytes = await readFile(file).catch(() => null);
  response.writeHead(bytes ? 200 : 404, { 'content-type': kTypes[extname(file)] ?? 'application/octet-stream' });
  response.end(bytes ?? '');
}

const server = createServer((request, response) => {
  const { pathname } = new URL(request.url, 'http://localhost');
  if (pathname === '/result') receive(request, response).catch(finish);
  else send(pathname, response);
});

await mkdir(out, { recursive: true });
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const profile = await mkdtemp(join(tmpdir(), 'peers-'));
const start = `http://127.0.0.1:${server.address().port}${addressOf(cases[0])}`;
const flags = [...kChromiumFlags, `--user-data-dir=${profile}`, start];
const browser = spawn(process.env.CHROMIUM ?? 'chromium', flags, { detached: true, stdio: 'ignore' });
browser.on('error', finish);
expect(cases[0]);

const failure = await finished;
clearTimeout(timer);
if (browser.pid) {
  const gone = new Promise((resolve) => browser.on('exit', resolve));
  process.kill(-browser.pid);
  await gone;
}
server.closeAllConnections();
server.close();
await rm(profile, { recursive: true, force: true, maxRetries: 5 });
await writeFile(join(out, 'captures.tsv'), rows.map((row) => row.join('\t') + '\n').join(''));
if (failure) {
  console.error(failure.message);
  process.exitCode = 1;
}
