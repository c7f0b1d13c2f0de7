// SPDX-License-Identifier: MIT
// Watches WebGL 1 from outside the engine: which program draws the sphere, and what its two sources are.
// The sphere is known by its number of indices; helper programs (mipmaps, copies, skies) never draw that many.

const kAbsentOnVc4 = /derivatives|shader_texture_lod|float|sRGB|blend_minmax/;

// Which extensions the engine does not find. With 'vc4-flat' it believes in derivatives, and they are taken out of its text:
// what its program would cost where it has no fallback of its own.
const kHidden = {
  all: () => false,
  vc4: (name) => kAbsentOnVc4.test(name),
  'vc4-flat': (name) => kAbsentOnVc4.test(name) && !/derivatives/.test(name),
};

const kFlat = '#define dFdx(x) ((x) * 0.0)\n#define dFdy(x) ((x) * 0.0)\n#define fwidth(x) ((x) * 0.0)\n';

function withoutDerivatives(source) {
  return kFlat + source.replace(/#extension\s+GL_OES_standard_derivatives.*/g, '');
}

const sources = new WeakMap();  // WebGLShader → text
const stages = new WeakMap();   // WebGLProgram → { vertex, fragment, linked }
let current = null;
let drawn = null;

function wrap(prototype, name, before) {
  const original = prototype[name];
  prototype[name] = function (...parameters) {
    return original.apply(this, before.call(this, ...parameters) ?? parameters);
  };
}

function watchPrograms(gl, extensions, indexCount) {
  wrap(gl, 'shaderSource', function (shader, source) {
    const text = extensions === 'vc4-flat' ? withoutDerivatives(source) : source;
    sources.set(shader, text);
    return [shader, text];
  });
  wrap(gl, 'attachShader', function (program, shader) {
    const fragment = this.getShaderParameter(shader, this.SHADER_TYPE) === this.FRAGMENT_SHADER;
    const pair = stages.get(program) ?? {};
    pair[fragment ? 'fragment' : 'vertex'] = sources.get(shader);
    stages.set(program, pair);
  });
  wrap(gl, 'useProgram', function (program) { current = program; });
  wrap(gl, 'drawElements', function (mode, count) {
    if (count !== indexCount) return;
    drawn = stages.get(current);
    drawn.linked = this.getProgramParameter(current, this.LINK_STATUS);
  });
}

function hideExtensions(gl, hidden) {
  const get = gl.getExtension;
  const list = gl.getSupportedExtensions;
  gl.getExtension = function (name) { return hidden(name) ? null : get.call(this, name); };
  gl.getSupportedExtensions = function () { return list.call(this).filter((name) => !hidden(name)); };
}

// Installs the hooks; to be called before the engine is loaded. WebGL 2 is refused, and the last frame can be read back.
export function watch(extensions, indexCount) {
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, attributes) {
    if (kind === 'webgl2' || kind === 'webgpu') return null;
    return getContext.call(this, kind, { ...attributes, preserveDrawingBuffer: true });
  };
  hideExtensions(WebGLRenderingContext.prototype, kHidden[extensions]);
  watchPrograms(WebGLRenderingContext.prototype, extensions, indexCount);
}

export function programOfDraw() {
  if (!drawn) throw new Error('the engine did not draw the sphere');
  return drawn;
}
