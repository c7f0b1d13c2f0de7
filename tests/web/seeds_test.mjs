// SPDX-License-Identifier: MIT
// The presets' direct light against the pages' own shaders, which are taken out of their texts and drawn with the same
// mesh and numbers. Where a page's formula differs in kind from ours, it is drawn as it stands, which says by how much,
// and with these terms replaced, which shows that nothing else differs. SEEDS is the folder of the pages.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { difference, inside, openBrowser, pixelsOf, readPixels, withoutMultisampling } from "./browser.mjs";

const { SEEDS } = process.env;
const kBackground = [33, 33, 36];

let browser, page;
before(async () => {
  browser = await openBrowser();
  page = await browser.open("", { before: withoutMultisampling });
});
after(() => browser.close());

/** The blocks of code of a page. */
function blocksOf(number) {
  const file = readdirSync(SEEDS).find((name) => name.startsWith(number));
  return [...readFileSync(`${SEEDS}/${file}`, "utf8").matchAll(/```\w*\n([^]*?)```/g)].map(([, text]) => text.trim());
}

/** Functions and structs: pieces of statements are left out. */
const definitionsOf = (blocks) => blocks.filter((text) => /^(struct \w+|(float|vec3|void) \w+\()/.test(text));

/** A function of a page, by its name; where there are several, the first. */
function functionOf(blocks, name) {
  const text = blocks.find((block) => new RegExp(`(float|vec3) ${name}\\(`).test(block));
  const from = text.search(new RegExp(`(float|vec3) ${name}\\(`));
  return text.slice(from, text.indexOf("\n}", from) + 2);
}

/** The statement of a page that starts so. */
function statementOf(blocks, start) {
  const found = blocks.flatMap((text) => text.split(/(?<=;)\n/)).find((line) => line.trimStart().startsWith(start));
  assert.ok(found, start);
  return found;
}

const kVaryings = "varying vec3 vPosition;\nvarying vec3 vNormal;\nvarying vec3 vTangent;\nvarying vec2 vUv;\n";
const kHead = `precision highp float;\n${kVaryings}const float PI = 3.14159265358979;\n`;
const kVertex = `attribute vec3 aPosition;
attribute vec3 aNormal;
attribute vec4 aTangent;
attribute vec2 aUv0;
uniform mat4 uModelViewProjection;
${kVaryings}
void main() {
  vPosition = aPosition;
  vNormal = aNormal;
  vTangent = aTangent.xyz;
  vUv = aUv0;
  gl_Position = uModelViewProjection * vec4(aPosition, 1.0);
}`;

/** Draws the page's sphere with those shaders in place of ours: what our program was given, by its uniforms' names. */
async function drawWith({ vertex = kVertex, fragment, uniforms, samplers = {} }) {
  await page.evaluate(({ vertex, fragment, uniforms, samplers }) => {
    const { picture, state } = playground;
    const { driver } = picture;
    const { gl } = driver;
    const described = playground.describe(state.name);
    const attributes = [["aPosition", 0], ["aNormal", 1], ["aTangent", 2], ["aUv0", 3]].map(([name, location]) => ({ name, location }));
    const other = { name: "a page's", vertex: { text: vertex }, fragment: { text: fragment }, attributes, uniforms: [],
      samplers: Object.entries(samplers).map(([name, unit]) => ({ name, unit })), words: new Set() };
    driver.programs.delete(other.name);
    const { program } = driver.program(other);
    driver.begin(picture.canvas.width, picture.canvas.height, [0.13, 0.13, 0.14]);
    gl.useProgram(program);
    const eye = picture.packed.frame.slice(0, 3);
    const offset = described.uniforms.find(({ name }) => name === "uModelViewProjection").offset;
    const object = picture.pack("packObject", "object", picture.packed.object);
    for (const name of ["uModelViewProjection", "uMVP"])
      gl.uniformMatrix4fv(gl.getUniformLocation(program, name), false, object.subarray(offset, offset + 16));
    for (const [name, value] of Object.entries({ ...uniforms, u_viewPos: eye, uCameraPosWorld: eye })) {
      const place = gl.getUniformLocation(program, name);
      const numbers = [value].flat();
      if (place && numbers.length === 16)
        gl.uniformMatrix4fv(place, false, numbers);
      else if (place)
        gl[`uniform${numbers.length}fv`](place, numbers);
    }
    const [item] = playground.scene().items;
    driver.bindVertices(attributes, item.mesh);
    for (const sampler of described.samplers)
      driver.bindTexture(sampler, playground.scene().patterns.get(sampler.name));
    gl.disable(gl.BLEND);
    gl.enable(gl.CULL_FACE);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, item.mesh.indices.of(driver));
    gl.drawElements(gl.TRIANGLES, item.mesh.count, gl.UNSIGNED_INT, 0);
  }, { vertex, fragment, uniforms, samplers });
  return readPixels(page);
}

/** The text with terms replaced, each by [what stands there, what takes its place]. */
function replaced(text, terms) {
  for (const [from, to] of terms) {
    assert.ok(text.includes(from), from);
    text = text.replaceAll(from, to);
  }
  return text;
}

async function differenceTo(what, own, shaders) {
  const other = await drawWith(shaders);
  const found = difference(own.rgba, other.rgba, inside(other, kBackground));
  const { mean, withinOne, most, count } = found;
  console.log(`${what}: mean ${mean.toFixed(4)}, ${(100 * withinOne).toFixed(3)} % within 1, most ${most}, ${count} channels`);
  assert.ok(count > 60000, what);
  return found;
}

/**
 * Holds our picture to a page's: as it stands, at most `asItStands` codes; with each of `kinds` replaced, which maps a
 * difference in kind to its terms, at most one.
 */
async function compare(what, shaders, { kinds = {}, asItStands = 1 } = {}) {
  const own = await pixelsOf(page);
  const { most } = await differenceTo(`${what}, as it stands`, own, shaders);
  assert.ok(most <= asItStands, `${what}: ${most}`);
  if (Object.keys(kinds).length === 0)
    return;
  const fragment = replaced(shaders.fragment, Object.values(kinds).flat());
  const rest = await differenceTo(`${what}, with ${Object.keys(kinds).join("; ")}`, own, { ...shaders, fragment });
  assert.ok(rest.most <= 1, `${what}: ${rest.most}`);
}

/** The preset by its button, then changed. Returns the state. */
async function preset(key, extra = {}) {
  await page.click(`#presets button[data-preset="${key}"]`);
  return page.evaluate((extra) => {
    playground.set(extra);
    return playground.state;
  }, extra);
}

test("000: three point lights, by its own functions", async () => {
  const names = { Pos: "vPosition", Normal: "vNormal" };
  const code = definitionsOf(blocksOf("000")).filter((text) => !text.includes("gl_Position"))
    .join("\n").replace(/\b(Pos|Normal)\b/g, (name) => names[name]);
  const fragment = `${kHead}uniform vec3 u_viewPos, u_albedo;\nuniform float u_metallic, u_roughness;\n${code}`;
  // It dims the diffuse light by the Fresnel term of the mixture; glTF mixes two surfaces, each with its own.
  const mixed = { "the Fresnel term of a dielectric": [["(vec3(1.0) - F) * diffuseColor", "(vec3(1.0) - Fresnel_Schlick(cosVH, vec3(0.04))) * diffuseColor"]] };
  for (const [metallic, roughness, differs] of [[0, 0.1], [0, 0.5], [1, 0.3], [0.5, 0.8, { kinds: mixed, asItStands: 16 }]]) {
    const { red, green, blue } = await preset("000", { metallic, roughness });
    const uniforms = { u_albedo: [red, green, blue], u_metallic: metallic, u_roughness: roughness };
    await compare(`000, metallic ${metallic}, roughness ${roughness}`, { fragment, uniforms }, differs);
  }
});

/** N.V is kept above 0.0001 here, above 0 there: a normal map can turn a normal away from the eye. */
const kKeptEye = (distribution) => ({
  "N.V kept above 0.0001": [
    ["max(dot(N, V), 0.0)", "max(dot(N, V), 1.0e-4)"],
    [distribution, distribution.replace("N, H", "N, H + N * (max(1.0e-4 - dot(N, V), 0.0) / length(V + L))")],
  ],
});

test("004: ambient colour and a sun, by its own shader", async () => {
  const whole = blocksOf("004").find((text) => text.startsWith("// Compiling FrankenShader"));
  const [vertexText, fragmentText] = whole.split("// FRAGMENT SHADER");
  // Its names for what the mesh has; our green points the other way than its cross(T, N).
  const vertex = vertexText.slice(vertexText.indexOf("attribute")).replaceAll("aUV0", "aUv0")
    .replaceAll("attribute vec3 aUv0", "attribute vec2 aUv0").replace("aUv0.xy", "aUv0").replace("cross(T, N)", "-cross(T, N)");
  const fragment = `precision highp float;\n${fragmentText.slice(fragmentText.indexOf("varying"))}`;
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const ofMetal = { kinds: kKeptEye("DistributionGGX(N, H, uMaterialRoughness)"), asItStands: 8 };
  for (const [key, ambient, metallic, differs] of [["004 sun", 0, 0], ["004 sun", 0, 0.5, ofMetal], ["004 sun", 0, 1, ofMetal], ["004 ambient", 0.3, 0]]) {
    const state = await preset(key, { metallic });
    const sun = await page.evaluate(() => playground.picture.packed.lights);
    const isSun = key.endsWith("sun");
    // packLights(): exposure, eye, precision, farthest, kind, colour, coefficients, how many suns, the first.
    const first = 1 + 3 + 1 + 1 + 1 + 3 + 27 + 1;
    const shaders = {
      vertex, fragment,
      uniforms: {
        uMaterialAlbedoColor: [state.red, state.green, state.blue, 1], uMaterialRoughness: state.roughness,
        uMaterialMetallic: state.metallic, uAmbientColor: Array(3).fill(ambient ** (1 / 2.2)),
        uLightRadiance0: Array(3).fill(isSun ? sun[first + 6] : 0), uLightDir0: isSun ? sun.slice(first, first + 3) : [0, -1, 0],
        uLocalToWorld: identity, uLocalToWorld_it: identity,
      },
      samplers: { uTextureAlbedo: 0, uTextureNormal: 1 },
    };
    await compare(`${key}, metallic ${metallic}`, shaders, differs);
  }
});

const kPointLight = { uLight: [2, 2, 3] };

test("002: a point light on textures, by its own functions", async () => {
  const blocks = blocksOf("002");
  const functions = ["fresnelSchlick", "GeometrySchlickGGX", "GeometrySmith", "DistributionGGX"].map((name) => functionOf(blocks, name));
  const statements = ["vec3 numerator", "// + 0.0001", "vec3 BRDF", "// Calculate the specular reflection", "// Calculate the diffuse", "kD *=", "// Scale the light", "// Calculate the direct"];
  // Its textures are taken as decoded: here, and by our program, which decodes nothing. Its bitangent is glTF's.
  const fragment = `${kHead}
uniform vec3 u_viewPos, uLight, uAlbedo;
uniform float uCandela;
uniform sampler2D uBase, uMetal, uRough, uNormals;
${functions.join("\n")}
void main() {
  vec3 normalWorld = vNormal, tangentWorld = vTangent;
  vec3 albedo = texture2D(uBase, vUv).rgb * uAlbedo;
  float metallic = texture2D(uMetal, vUv).r, roughness = texture2D(uRough, vUv).r;
  ${["vec3 N =", "// Adjust the tangent", "vec3 B ="].map((start) => statementOf(blocks, start)).join("\n")}
  mat3 TBN = mat3(T, B, N);
  N = normalize(TBN * (texture2D(uNormals, vUv).xyz * 2.0 - 1.0));
  vec3 V = normalize(u_viewPos - vPosition), L = normalize(uLight - vPosition), H = normalize(V + L);
  vec3 radiance = vec3(uCandela / dot(uLight - vPosition, uLight - vPosition));
  vec3 F0 = mix(vec3(0.04), albedo, metallic);
  vec3 F = fresnelSchlick(max(dot(H, V), 0.0), F0);
  float G = GeometrySmith(N, V, L, roughness), NDF = DistributionGGX(N, H, roughness);
  ${statements.map((start) => statementOf(blocks, start)).join("\n")}
  vec3 color = directLight;
  color = color / (color + vec3(1.0));
  gl_FragColor = vec4(pow(color, vec3(1.0 / 2.2)), 1.0);
}`;
  const kinds = {
    "a divisor kept above 0.001": [["4.0 * max(dot(N, V), 0.0) * max(dot(N, L), 0.0) + 0.0001", "max(4.0 * max(dot(N, V), 0.0) * max(dot(N, L), 0.0), 0.001)"]],
    ...kKeptEye("DistributionGGX(N, H, roughness)"),
  };
  const { red, green, blue, candela } = await preset("002", { name: "basecolor.metalrough-separate.normal+punctual1+seed+decode-none+reinhard+pow22" });
  await compare("002", {
    fragment, uniforms: { ...kPointLight, uAlbedo: [red, green, blue], uCandela: candela }, samplers: { uBase: 0, uNormals: 1, uMetal: 2, uRough: 3 },
  }, { kinds, asItStands: 7 });
});

test("003: a point light, by the formulas that it names", async () => {
  const blocks = blocksOf("003");
  // It gives the parts of its material, f = c/pi + F G D / (4 n.l n.v) and Schlick's F by name; G and D are the theory's.
  const fragment = `${kHead}
uniform vec3 u_viewPos, uLight, u_color;
uniform float uCandela, u_metallic, u_roughness;
struct Material { float roughness, metallic; vec3 diffuse, specular; };
const vec3 f0_specular = vec3(0.04);
void main() {
  Material material;
  ${["material.roughness", "material.metallic", "material.diffuse", "material.specular"].map((start) => statementOf(blocks, start)).join("\n")}
  vec3 n = normalize(vNormal), v = normalize(u_viewPos - vPosition), l = normalize(uLight - vPosition), h = normalize(v + l);
  float nl = max(dot(n, l), 0.0), nv = max(dot(n, v), 1.0e-4), nh = max(dot(n, h), 0.0), a2 = pow(material.roughness, 4.0);
  float schlick = pow(1.0 - dot(v, h), 5.0);
  vec3 F = material.specular + (1.0 - material.specular) * schlick;
  float root = nv * sqrt(a2 + (1.0 - a2) * nl * nl) + nl * sqrt(a2 + (1.0 - a2) * nv * nv);
  float G = 2.0 * nl * nv / max(root, 1.0e-9);
  float D = a2 / (PI * pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
  vec3 lambert = material.diffuse / PI;
  vec3 f = lambert + F * G * D / max(4.0 * nl * nv, 1.0e-9);
  vec3 color = f * nl * uCandela / dot(uLight - vPosition, uLight - vPosition);
  gl_FragColor = vec4(pow(min(color, 1.0), vec3(1.0 / 2.2)), 1.0);
}`;
  // It adds what is scattered without taking from it what is mirrored.
  const kinds = { "diffuse light dimmed by the dielectric's Fresnel term": [["lambert +", "lambert * (0.96 - 0.96 * schlick) +"]] };
  // As its preset, and as its picture of punctual light alone.
  for (const [numbers, asItStands] of [[{}, 2], [{ metallic: 0.715, roughness: 0.41, red: 169 / 255, green: 126 / 255, blue: 126 / 255 }, 2]]) {
    const state = await preset("003", { name: "punctual1+pow22", ...numbers });
    const { red, green, blue, candela, metallic, roughness } = state;
    const uniforms = { ...kPointLight, u_color: [red, green, blue], u_metallic: metallic, u_roughness: roughness, uCandela: candela };
    await compare(`003, metallic ${metallic}, roughness ${roughness}`, { fragment, uniforms }, { kinds, asItStands });
  }
});
