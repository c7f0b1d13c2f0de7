// SPDX-License-Identifier: MIT
// The page: its controls change the state, and the state is shown.
import { Library } from "./module.js";
import { Picture } from "./picture.js";
import { kPresets } from "./presets.js";
import { Prices, priceTable } from "./price.js";
import { fileScene, sphereScene } from "./scene.js";
import { filterSky, kNoSky } from "./sky.js";
import { SourceView } from "./source.js";
import { kFirst, kNumbers, readState, writeState } from "./state.js";
import { download, element, optionOf } from "./dom.js";

const kDegreesASecond = 24;

async function bytesOf(file) {
  const answer = await fetch(file);
  if (!answer.ok)
    throw new Error(`${file}: ${answer.status} ${answer.statusText}`);
  return new Uint8Array(await answer.arrayBuffer());
}

async function unzipped(file) {
  const stream = new Blob([await bytesOf(file)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

class Page {
  constructor(library, prices) {
    this.library = library;
    this.prices = prices;
    this.described = library.describe();
    this.programs = new Map();
    this.scenes = new Map();
    this.sources = { vertex: new SourceView(element("vertex"), element("origin")), fragment: new SourceView(element("fragment"), element("origin")) };
    this.state = readState(location.hash);
    this.sky = kNoSky;
    this.turning = false;
    this.makeControls();
    this.makeNumbers();
    this.makePresets();
    this.makePicture();
    this.listen();
  }

  describe(name) {
    if (!this.programs.has(name)) {
      const program = this.library.program(name);
      program.words = new Set(program.values.map((value, i) => this.described.choices[i].options[value].word));
      this.programs.set(name, program);
    }
    return this.programs.get(name);
  }

  makePicture() {
    const canvas = element("picture");
    try {
      this.picture = new Picture(canvas, this.library, this.described, () => this.draw());
    } catch (error) {
      this.sayOfPicture(error.message);
    }
    this.scenes.set("sphere", sphereScene(this.library, this.described.roles));
  }

  makeControls() {
    element("controls").append(...this.described.choices.map((choice, i) => {
      const label = document.createElement("label");
      const select = document.createElement("select");
      select.dataset.choice = i;
      select.append(...choice.options.map(({ word, meaning }) => optionOf(word, `${word}: ${meaning}`)));
      select.addEventListener("change", () => this.choose(i, select.selectedIndex));
      label.append(choice.name.replace(/([A-Z])/g, " $1").toLowerCase(), select);
      return label;
    }));
  }

  makeNumbers() {
    element("numbers").append(...Object.entries(kNumbers).map(([key, [title, least, most, step]]) => {
      const label = document.createElement("label");
      const slider = Object.assign(document.createElement("input"), { type: "range", min: least, max: most, step, id: `number-${key}` });
      slider.addEventListener("input", () => this.set({ [key]: Number(slider.value) }));
      label.append(title, slider, document.createElement("output"));
      return label;
    }));
  }

  makePresets() {
    element("presets").append(...Object.entries(kPresets).map(([key, { title }]) => {
      const button = document.createElement("button");
      button.textContent = title;
      button.dataset.preset = key;
      button.addEventListener("click", () => this.set({ ...kFirst, ...kPresets[key].state, preset: key }));
      return button;
    }));
  }

  /** Takes part of another state. A name that is refused leaves the state alone. */
  set(part) {
    try {
      if (part.name) {
        part.name = this.describe(part.name).name;
        this.say("");
      }
    } catch (error) {
      this.say(error.message, true);
      return;
    }
    const isLooking = ["yaw", "pitch", "distance"].some((key) => key in part) && Object.keys(part).every((key) => !(key in kNumbers) && key !== "name");
    this.state = { ...this.state, ...part };
    if (isLooking) {
      this.draw();
      this.keepAddress();
    } else {
      this.show();
    }
  }

  choose(choice, option) {
    try {
      const { name, dropped } = this.library.choose(this.state.name, choice, option);
      this.set({ name });
      this.say(dropped.map(({ word, reason }) => `${word} was dropped: ${reason}.`).join(" "));
    } catch (error) {
      this.say(error.message, true);
      this.showControls(this.describe(this.state.name));
    }
  }

  say(text, isRefusal = false) {
    element("says").textContent = text;
    element("says").classList.toggle("refused", isRefusal);
  }

  sayOfPicture(text) {
    element("picture-says").textContent = text;
    element("picture-says").hidden = !text;
  }

  /** The program that is looked into: the page's, or that of a file's material. */
  shownProgram() {
    const material = this.scene()?.materials[element("material").selectedIndex];
    return this.describe(material ? this.library.withMaterial(this.state.name, material.permutation) : this.state.name);
  }

  scene() { return this.scenes.get(this.state.shape); }

  show() {
    this.keepAddress();
    this.provide();
    this.showMaterials();
    const program = this.shownProgram();
    this.showControls(program);
    this.showNumbers();
    this.showPreset();
    this.showProgram(program);
    this.draw();
  }

  keepAddress() {
    history.replaceState(null, "", writeState(this.state));
  }

  /** Loads what the state needs and is not there yet. */
  provide() {
    const { words } = this.describe(this.state.name);
    if (words.has("sh") || words.has("sky"))
      this.skyComes ??= this.loadSky("evening.hdr");
    if (this.state.shape === "model" && !this.scenes.has("model"))
      this.modelComes ??= this.loadModel("model", "model.glb");
    if (!this.scenes.has(this.state.shape) && this.state.shape !== "model")
      this.state.shape = "sphere";
    element("shape").value = this.state.shape;
  }

  async loadSky(file) {
    this.sayOfFile("The sky is being filtered …");
    try {
      await this.takeSky(await bytesOf(file));
      this.sayOfFile("");
    } catch (error) {
      this.sayOfFile(error.message, true);
    }
  }

  async takeSky(bytes) {
    this.sky = await filterSky(this.library.module, bytes);
    this.draw();
  }

  async loadModel(shape, file) {
    this.sayOfFile("The model is being loaded …");
    try {
      await this.takeModel(shape, file, await bytesOf(file));
    } catch (error) {
      this.sayOfFile(error.message, true);
    }
  }

  async takeModel(shape, name, bytes) {
    try {
      this.scenes.set(shape, await fileScene(this.library, name, bytes));
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError))
        throw error;
      await this.library.start();
      throw new Error(`${name}: the parser gave up: the file is broken, or needs more memory than a page has`);
    }
    if (![...element("shape").options].some(({ value }) => value === shape))
      element("shape").append(optionOf(shape, name));
    this.sayOfFile(this.scenes.get(shape).warnings.join(" "));
    this.state.shape = shape;
    this.show();
  }

  sayOfFile(text, isRefusal = false) {
    element("file-says").textContent = text;
    element("file-says").classList.toggle("refused", isRefusal);
  }

  async open(file) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    try {
      if (/\.(hdr|hdre|sky)$/i.test(file.name)) {
        this.sayOfFile("The sky is being filtered …");
        await (this.skyComes = this.takeSky(bytes));
        this.sayOfFile(`${file.name} is the sky of all programs with sh or reflection.`);
      } else {
        await this.takeModel("file", file.name, bytes);
      }
    } catch (error) {
      this.sayOfFile(error.message, true);
    }
  }

  showMaterials() {
    const { materials = [] } = this.scene() ?? {};
    const select = element("material");
    element("material-label").hidden = materials.length === 0;
    if (select.dataset.of === this.state.shape && select.length === materials.length)
      return;
    select.dataset.of = this.state.shape;
    select.replaceChildren(...materials.map(({ name }, i) => optionOf(String(i), name || `material ${i}`)));
  }

  showControls(program) {
    const isFile = this.scene()?.isOwn === false;
    for (const select of element("controls").querySelectorAll("select")) {
      const choice = this.described.choices[select.dataset.choice];
      select.selectedIndex = program.values[select.dataset.choice];
      select.disabled = isFile && choice.material;
      select.title = select.disabled ? "The file's materials decide this." : "";
      select.parentElement.classList.toggle("set", select.selectedIndex !== 0);
    }
    element("name").value = this.state.name;
  }

  showNumbers() {
    for (const key of Object.keys(kNumbers)) {
      const slider = element(`number-${key}`);
      slider.value = this.state[key];
      slider.nextElementSibling.textContent = this.state[key].toFixed(2);
    }
  }

  showPreset() {
    const preset = kPresets[this.state.preset];
    element("preset-says").textContent = preset ? `${this.state.preset.slice(0, 3)}. ${preset.notes}` : "";
    for (const button of element("presets").children)
      button.setAttribute("aria-pressed", button.dataset.preset === this.state.preset);
  }

  showProgram(program) {
    for (const stage of ["vertex", "fragment"])
      this.sources[stage].show(program[stage]);
    element("lint").textContent = program.lint.length === 0 ? "Lint finds nothing." : program.lint.join(" ");
    element("price").replaceChildren(...priceTable(this.prices.of(program.name, program.words)));
    this.showBudget(program.budgets);
    element("ladder").replaceChildren(...program.ladder.map((name) => {
      const item = document.createElement("li");
      item.append(Object.assign(document.createElement("code"), { textContent: name }));
      return item;
    }));
  }

  showBudget(budgets) {
    const table = element("budget");
    table.replaceChildren();
    const head = table.createTHead().insertRow();
    for (const title of ["GPU", ...budgets[0].uses.map(({ resource }) => resource)])
      head.append(Object.assign(document.createElement("th"), { textContent: title, scope: "col" }));
    const body = table.createTBody();
    for (const { profile, uses, fits } of budgets) {
      const row = body.insertRow();
      row.append(Object.assign(document.createElement("th"), { textContent: fits ? profile : `${profile}: too much`, scope: "row" }));
      for (const { used, limit } of uses) {
        const cell = row.insertCell();
        cell.textContent = `${used} of ${limit}`;
        cell.classList.toggle("over", used > limit);
      }
    }
    element("advice").replaceChildren(...budgets.flatMap(({ profile, advice }) =>
      advice.map((text) => Object.assign(document.createElement("li"), { textContent: `${profile}, ${text}` }))));
  }

  draw() {
    const scene = this.scene();
    if (!this.picture || !scene)
      return;
    try {
      this.picture.draw({
        state: this.state, scene, sky: this.sky, own: kPresets[this.state.preset]?.lights, describe: (name) => this.describe(name),
      });
      this.sayOfPicture("");
    } catch (error) {
      this.sayOfPicture(error.message);
    }
  }

  turn(isTurning) {
    this.turning = isTurning;
    element("turning").setAttribute("aria-pressed", isTurning);
    let last = performance.now();
    const step = (now) => {
      if (!this.turning)
        return;
      this.state.yaw = (this.state.yaw + (now - last) / 1000 * kDegreesASecond) % 360;
      last = now;
      this.draw();
      requestAnimationFrame(step);
    };
    if (isTurning)
      requestAnimationFrame(step);
    else
      this.keepAddress();
  }

  orbit(yaw, pitch, zoom = 1) {
    this.set({
      yaw: this.state.yaw + yaw,
      pitch: Math.min(Math.max(this.state.pitch + pitch, -89), 89),
      distance: Math.min(Math.max(this.state.distance * zoom, 1.2), 50),
    });
  }

  listen() {
    element("shape").append(optionOf("sphere", "Sphere"), optionOf("model", "Urn"));
    element("shape").addEventListener("change", ({ target }) => this.set({ shape: target.value }));
    element("material").addEventListener("change", () => this.show());
    element("name").addEventListener("change", ({ target }) => this.set({ name: target.value }));
    addEventListener("hashchange", () => {
      const { name, ...rest } = readState(location.hash);
      this.set({ ...rest, name });
    });
    element("turning").addEventListener("click", () => this.turn(!this.turning));
    element("file").addEventListener("change", ({ target }) => target.files[0] && this.open(target.files[0]));
    this.listenToDrops();
    this.listenToCanvas(element("picture"));
    this.listenToSaving();
  }

  listenToDrops() {
    const mark = (event, isOver) => {
      event.preventDefault();
      document.body.classList.toggle("dropping", isOver);
    };
    addEventListener("dragover", (event) => mark(event, true));
    addEventListener("dragleave", (event) => mark(event, false));
    addEventListener("drop", (event) => {
      mark(event, false);
      const [file] = event.dataTransfer.files;
      if (file)
        this.open(file);
    });
  }

  listenToCanvas(canvas) {
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (canvas.hasPointerCapture(event.pointerId))
        this.orbit(-event.movementX / canvas.clientHeight * 180, event.movementY / canvas.clientHeight * 180);
    });
    canvas.addEventListener("keydown", (event) => {
      const move = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5], "+": [0, 0, 0.9], "-": [0, 0, 1.1] }[event.key];
      if (!move)
        return;
      event.preventDefault();
      this.orbit(...move);
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.orbit(0, 0, event.deltaY > 0 ? 1.1 : 0.9);
    }, { passive: false });
  }

  listenToSaving() {
    const text = (stage) => this.shownProgram()[stage].text;
    element("copy").addEventListener("click", async () => {
      await navigator.clipboard.writeText(`${text("vertex")}\n${text("fragment")}`);
      element("copied").textContent = "Both shaders are in the clipboard.";
    });
    element("save-vertex").addEventListener("click", () => download(`${this.shownProgram().name}.vert`, text("vertex")));
    element("save-fragment").addEventListener("click", () => download(`${this.shownProgram().name}.frag`, text("fragment")));
    element("save-header").addEventListener("click", () => download("shaders.h", this.library.header(this.shownProgram().name)));
    element("save-picture").addEventListener("click", () => {
      element("picture").toBlob((blob) => download(`${this.state.name}.png`, blob));
    });
  }
}

async function start() {
  const [wasm, table, list] = await Promise.all([unzipped("playground.wasm.gz"), bytesOf("costs.tsv"), bytesOf("prices.md")]);
  const decoder = new TextDecoder();
  const page = new Page(await Library.load(wasm), new Prices(decoder.decode(table), decoder.decode(list)));
  globalThis.playground = page; // For who looks into it, and for tests.
  page.set({ name: page.state.name });
  if (page.programs.size === 0)
    page.set({ name: kFirst.name });
  if (page.picture && !matchMedia("(prefers-reduced-motion: reduce)").matches && !location.hash.includes("yaw="))
    page.turn(true);
  document.body.dataset.ready = "yes";
}

start().catch((error) => {
  element("picture-says").textContent = `The playground does not start: ${error.message}`;
  element("picture-says").hidden = false;
});
