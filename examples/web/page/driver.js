// SPDX-License-Identifier: MIT
// Draws with the library's programs in WebGL 1: the texts, the interface and the blocks of uniforms are the library's.

const kSetters = {
  float: "uniform1fv", vec2: "uniform2fv", vec3: "uniform3fv", vec4: "uniform4fv",
  mat3: "uniformMatrix3fv", mat4: "uniformMatrix4fv",
};
const kFloats = { float: 1, vec2: 2, vec3: 3, vec4: 4, mat3: 9, mat4: 16 };

/** By attribute, the array of a mesh and its floats a vertex; what a vertex has where the mesh has no such array. */
const kStreams = {
  aPosition: ["positions", 3, [0, 0, 0, 1]],
  aNormal: ["normals", 3, [0, 0, 1, 0]],
  aTangent: ["tangents", 4, [1, 0, 0, 1]],
  aUv0: ["uv0", 2, [0, 0, 0, 0]],
  aUv1: ["uv1", 2, [0, 0, 0, 0]],
  aColor: ["colors", 4, [1, 1, 1, 1]],
  aJoints: ["joints", 4, [0, 0, 0, 0]],
  aWeights: ["weights", 4, [1, 0, 0, 0]],
};

const kWraps = ["REPEAT", "CLAMP_TO_EDGE", "MIRRORED_REPEAT"];
const kFilters = ["NEAREST", "LINEAR", "NEAREST_MIPMAP_NEAREST", "LINEAR_MIPMAP_NEAREST", "NEAREST_MIPMAP_LINEAR",
  "LINEAR_MIPMAP_LINEAR"];

const isPowerOfTwo = (size) => (size & (size - 1)) === 0;

/** Makes a GL object when it is first needed, and again after the context was lost. */
class Made {
  constructor(make) {
    this.make = make;
    this.age = -1;
  }

  of(driver) {
    if (this.age !== driver.age) {
      this.object = this.make(driver.gl, driver);
      this.age = driver.age;
    }
    return this.object;
  }
}

export class Driver {
  /** onChange is called when the context came back. Throws where there is no WebGL. */
  constructor(canvas, roles, onChange) {
    this.age = 0;
    this.roles = roles;
    this.programs = new Map();
    const asked = { alpha: false, antialias: true, preserveDrawingBuffer: true };
    this.gl = canvas.getContext("webgl", asked);
    if (!this.gl)
      throw new Error("this browser has no WebGL: sources, budgets and prices are shown without pictures");
    this.gl.getExtension("OES_element_index_uint");
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      ++this.age;
      this.programs.clear();
      this.gl.getExtension("OES_element_index_uint");
      onChange();
    });
    const texels = roles.map(({ texel }) => ({ width: 1, height: 1, rgba: Uint8Array.from(texel) }));
    this.defaults = texels.map((texel) => textureOf(texel, kClamped));
    this.defaultCubes = texels.map((texel) => cubeOf(Array(6).fill(texel)));
  }

  /** Compiles and links; throws what the driver says, with its lines. */
  program(described) {
    const kept = this.programs.get(described.name);
    if (kept)
      return kept;
    const { gl } = this;
    const program = gl.createProgram();
    for (const stage of ["vertex", "fragment"])
      gl.attachShader(program, this.shader(described, stage));
    for (const { name, location } of described.attributes)
      gl.bindAttribLocation(program, location, name);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error(`the browser does not link ${described.name}: ${gl.getProgramInfoLog(program)}`);
    const linked = {
      program,
      described,
      uniforms: described.uniforms.map((uniform) => ({
        ...uniform,
        place: gl.getUniformLocation(program, uniform.count > 1 ? `${uniform.name}[0]` : uniform.name),
      })),
    };
    gl.useProgram(program);
    for (const { name, unit } of described.samplers)
      gl.uniform1i(gl.getUniformLocation(program, name), unit);
    this.programs.set(described.name, linked);
    return linked;
  }

  shader(described, stage) {
    const { gl } = this;
    const shader = gl.createShader(stage === "vertex" ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
    gl.shaderSource(shader, described[stage].text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
      throw new Error(`the browser does not compile the ${stage} shader of ${described.name}: ${gl.getShaderInfoLog(shader)}`);
    return shader;
  }

  /** Clears to a colour of the display's own encoding. */
  begin(width, height, [r, g, b]) {
    const { gl } = this;
    gl.viewport(0, 0, width, height);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.clearColor(r, g, b, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /**
   * Draws a mesh. blocks(block, offset, floats) gives the numbers of a uniform; textures maps a sampler's unit to a
   * texture; roles that miss theirs read a default texel.
   */
  draw({ described, mesh, blocks, textures, doubleSided, mirrored }) {
    const { gl } = this;
    const { program, uniforms } = this.program(described);
    gl.useProgram(program);
    for (const { place, type, count, block, offset } of uniforms)
      if (place !== null)
        this.setUniform(place, type, blocks(block, offset, kFloats[type] * count));
    for (const sampler of described.samplers)
      this.bindTexture(sampler, textures.get(sampler.unit));
    this.bindVertices(described.attributes, mesh);
    const isBlended = described.words.has("blend");
    gl[isBlended ? "enable" : "disable"](gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl[doubleSided ? "disable" : "enable"](gl.CULL_FACE);
    gl.frontFace(mirrored ? gl.CW : gl.CCW);
    gl.depthFunc(gl.LEQUAL);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.indices.of(this));
    gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
  }

  setUniform(place, type, numbers) {
    const { gl } = this;
    if (type.startsWith("mat"))
      gl[kSetters[type]](place, false, numbers);
    else
      gl[kSetters[type]](place, numbers);
  }

  bindTexture({ unit, name, type }, texture) {
    const { gl } = this;
    const isCube = type === "samplerCube";
    gl.activeTexture(gl.TEXTURE0 + unit);
    const role = this.roles.findIndex(({ sampler }) => sampler === name);
    const bound = texture ?? (isCube ? this.defaultCubes : this.defaults)[role];
    gl.bindTexture(isCube ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_2D, bound.of(this));
  }

  bindVertices(attributes, mesh) {
    const { gl } = this;
    for (let location = 0; location < 8; ++location)
      gl.disableVertexAttribArray(location);
    for (const { name, location } of attributes) {
      const [array, floats, constant] = kStreams[name];
      if (mesh[array]) {
        gl.bindBuffer(gl.ARRAY_BUFFER, mesh[array].of(this));
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, floats, gl.FLOAT, false, 0, 0);
      } else {
        gl.vertexAttrib4fv(location, constant);
      }
    }
  }
}

function buffer(target, numbers) {
  return new Made((gl) => {
    const made = gl.createBuffer();
    gl.bindBuffer(gl[target], made);
    gl.bufferData(gl[target], numbers, gl.STATIC_DRAW);
    return made;
  });
}

/** A mesh of arrays by the names of kStreams, and indices. */
export function meshOf(arrays, indices) {
  const mesh = { count: indices.length, indices: buffer("ELEMENT_ARRAY_BUFFER", indices) };
  for (const [name, numbers] of Object.entries(arrays))
    if (numbers.length > 0)
      mesh[name] = buffer("ARRAY_BUFFER", numbers);
  return mesh;
}

function setSampling(gl, target, { wrapS, wrapT, min, mag }) {
  gl.texParameteri(target, gl.TEXTURE_WRAP_S, gl[kWraps[wrapS]]);
  gl.texParameteri(target, gl.TEXTURE_WRAP_T, gl[kWraps[wrapT]]);
  gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, gl[kFilters[min]]);
  gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, gl[kFilters[mag]]);
}

export const kRepeated = { wrapS: 0, wrapT: 0, min: 5, mag: 1 };
export const kClamped = { wrapS: 1, wrapT: 1, min: 1, mag: 1 };

/** WebGL 1 neither repeats nor makes levels of a size that is no power of two: such a texture is clamped. */
function fitting(sampling, width, height) {
  if (isPowerOfTwo(width) && isPowerOfTwo(height))
    return sampling;
  return { ...sampling, wrapS: 1, wrapT: 1, min: sampling.min % 2 };
}

/** Pixels as they are: an ImageBitmap, or {width, height, rgba}. */
function upload(gl, target, image) {
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  if (image.rgba)
    gl.texImage2D(target, 0, gl.RGBA, image.width, image.height, 0, gl.RGBA, gl.UNSIGNED_BYTE, image.rgba);
  else
    gl.texImage2D(target, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
}

export function textureOf(image, sampling) {
  return new Made((gl) => {
    const made = gl.createTexture();
    const fit = fitting(sampling, image.width, image.height);
    gl.bindTexture(gl.TEXTURE_2D, made);
    upload(gl, gl.TEXTURE_2D, image);
    setSampling(gl, gl.TEXTURE_2D, fit);
    if (fit.min > 1)
      gl.generateMipmap(gl.TEXTURE_2D);
    return made;
  });
}

/** Six faces in the order of a cube map's. */
export function cubeOf(faces) {
  return new Made((gl) => {
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_CUBE_MAP, made);
    faces.forEach((face, i) => upload(gl, gl.TEXTURE_CUBE_MAP_POSITIVE_X + i, face));
    setSampling(gl, gl.TEXTURE_CUBE_MAP, kClamped);
    return made;
  });
}
