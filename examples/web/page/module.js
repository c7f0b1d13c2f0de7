// SPDX-License-Identifier: MIT
// The library, compiled to WebAssembly: texts and numbers go in and come out as module/exchange.h says.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** What a system would do, which a page has not got: no files, no clock. */
function systemFor(module, memory) {
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = name === "proc_exit"
      ? () => { throw new Error("the module ended"); }
      : (...parameters) => name === "fd_write" ? discard(memory(), parameters) : 8; // 8: no such descriptor
  }
  return imports;
}

/** Counts what was to be printed as printed. */
function discard(memory, [, vectors, count, written]) {
  const view = new DataView(memory.buffer);
  let sum = 0;
  for (let i = 0; i < count; ++i)
    sum += view.getUint32(vectors + 8 * i + 4, true);
  view.setUint32(written, sum, true);
  return 0;
}

/** An error in the library's words. */
export class Refusal extends Error {
  constructor({ text, what, remedy }) {
    super(text);
    this.what = what;
    this.remedy = remedy;
  }
}

export class Library {
  static async load(source) {
    return Library.from(await WebAssembly.compile(source));
  }

  static async from(module) {
    const library = new Library(module);
    await library.start();
    return library;
  }

  constructor(module) {
    this.module = module;
  }

  async start() {
    const instance = await WebAssembly.instantiate(this.module, systemFor(this.module, () => this.exports.memory));
    this.exports = instance.exports;
    this.exports._initialize();
  }

  write(bytes) {
    const address = this.exports.reserve(bytes.length); // The memory may grow, and be another buffer then.
    new Uint8Array(this.exports.memory.buffer, address, bytes.length).set(bytes);
  }

  answer() {
    const bytes = new Uint8Array(this.exports.memory.buffer, this.exports.answerData(), this.exports.answerSize());
    return decoder.decode(bytes);
  }

  /** Calls a function that answers JSON, and throws a Refusal where that has an error. */
  ask(name, ...parameters) {
    this.exports[name](...parameters);
    const answer = JSON.parse(this.answer());
    if (answer.error)
      throw new Refusal(answer.error);
    return answer;
  }

  /** The same with a text, or several, in front. */
  askAbout(name, texts, ...parameters) {
    const parts = [texts].flat().map((text) => encoder.encode(text));
    const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
      whole.set(part, at);
      at += part.length;
    }
    this.write(whole);
    return this.ask(name, ...parts.map((part) => part.length), ...parameters);
  }

  describe() { return this.ask("describe"); }
  choose(name, choice, option) { return this.askAbout("choose", name, choice, option); }
  program(name) { return this.askAbout("program", name); }
  withMaterial(light, material) { return this.askAbout("withMaterial", [light, material]).name; }
  covering() { return this.ask("covering"); }
  sphere(rings) { return this.ask("makeSphere", rings); }
  texture(role) { return this.ask("makeTexture", role); }

  header(name) {
    const bytes = encoder.encode(name);
    this.write(bytes);
    this.exports.header(bytes.length);
    return this.answer();
  }

  /** The scene of a file; its arrays are where numbersAt() and bytesAt() find them until the next call. */
  model(name, bytes) {
    const title = encoder.encode(name);
    const whole = new Uint8Array(title.length + bytes.length);
    whole.set(title);
    whole.set(bytes, title.length);
    this.write(whole);
    return this.ask("loadModel", title.length);
  }

  sky(bytes, faceSize) {
    this.write(bytes);
    return this.ask("loadSky", faceSize);
  }

  /** A block of uniforms from numbers: an address. */
  pack(name, numbers) {
    const doubles = Float64Array.from(numbers.flat(Infinity));
    this.write(new Uint8Array(doubles.buffer));
    return this.exports[name]();
  }

  floatsAt(address, count) { return new Float32Array(this.exports.memory.buffer, address, count); }
  copyFloats([address, count]) { return this.floatsAt(address, count).slice(); }
  copyIndices([address, count]) { return new Uint32Array(this.exports.memory.buffer, address, count).slice(); }
  copyBytes([address, count]) { return new Uint8Array(this.exports.memory.buffer, address, count).slice(); }
}
