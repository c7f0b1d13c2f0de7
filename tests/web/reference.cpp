// SPDX-License-Identifier: MIT
// web_reference JOB.json OUT.rgba: draws what the playground drew, once more: the same numbers, folded
// natively, the native texts, and Mesa's software rasteriser (OSMesa). A job is {"name", "width", "height",
// "background", "frame", "lights", "material", "object": the numbers that the page packed, "textures":
// {sampler: {"file", "width", "height"}}}. The sphere and its textures are the module's. Pixels come out as
// GL returns them, from the lowest row up.
#include "franken/generator/compose.h"
#include "franken/generator/pack.h"
#include "franken/generator/texture_role.h"
#include "support/offscreen.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>

// The module's functions (examples/web/module).
extern "C" {
void* reserveInput(std::size_t size);
const char* answerData();
std::size_t answerSize();
float* packMaterialBlock();
float* packLightsBlock();
float* packFrameBlock();
float* packObjectBlock();
float* packSkinBlock();
void makeSphere(int rings);
void makeTexture(unsigned role);
}

namespace {

using namespace franken;
using Json = nlohmann::json;

constexpr int kRings = 48; // As the page's scene.js has it.

[[noreturn]] void fail(const std::string& what) {
    std::cerr << "web_reference: " << what << "\n";
    std::_Exit(1);
}

Json answer() { return Json::parse(std::string(answerData(), answerSize())); }

/// An array of the module: [address, count].
template<typename Element>
const Element* at(const Json& array) {
    return reinterpret_cast<const Element*>(array[0].get<std::uintptr_t>());
}

float* pack(float* (*call)(), const std::vector<double>& numbers) {
    std::memcpy(reserveInput(numbers.size() * sizeof(double)), numbers.data(),
                numbers.size() * sizeof(double));
    return call();
}

unsigned compile(const Gl& gl, GLenum kind, const std::string& text) {
    const unsigned shader = gl.CreateShader(kind);
    const char* const source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    int compiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    return compiled ? shader : (fail("a shader does not compile"), 0u);
}

unsigned link(const Gl& gl, const Composed& composed) {
    const unsigned program = gl.CreateProgram();
    gl.AttachShader(program, compile(gl, GL_VERTEX_SHADER, composed.vertex.text));
    gl.AttachShader(program, compile(gl, GL_FRAGMENT_SHADER, composed.fragment.text));
    for (const Attribute& each : composed.interface.attributes)
        gl.BindAttribLocation(program, static_cast<unsigned>(each.location), each.name.c_str());
    gl.LinkProgram(program);
    int linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    return linked ? program : (fail("the program does not link"), 0u);
}

void setUniform(const Gl& gl, int place, const Uniform& uniform, const float* value) {
    switch (uniform.type) {
    case Type::Float:
        return gl.Uniform1fv(place, uniform.count, value);
    case Type::Vec2:
        return gl.Uniform2fv(place, uniform.count, value);
    case Type::Vec3:
        return gl.Uniform3fv(place, uniform.count, value);
    case Type::Vec4:
        return gl.Uniform4fv(place, uniform.count, value);
    case Type::Mat3:
        return gl.UniformMatrix3fv(place, uniform.count, GL_FALSE, value);
    case Type::Mat4:
        return gl.UniformMatrix4fv(place, uniform.count, GL_FALSE, value);
    case Type::Sampler2D:
    case Type::SamplerCube:
        break;
    }
}

void setUniforms(const Gl& gl, unsigned program, const Interface& interface, const Json& job) {
    const std::map<Block, const float*> blocks = {
        {Block::Frame, pack(packFrameBlock, job["frame"])},
        {Block::Lights, pack(packLightsBlock, job["lights"])},
        {Block::Material, pack(packMaterialBlock, job["material"])},
        {Block::Object, pack(packObjectBlock, job["object"])},
        {Block::Skin, pack(packSkinBlock, {})},
    };
    for (const Uniform& uniform : interface.uniforms)
        setUniform(gl, gl.GetUniformLocation(program, uniform.name.c_str()), uniform,
                   blocks.at(uniform.block) + fieldOffset(uniform));
    for (const Sampler& sampler : interface.samplers)
        gl.Uniform1i(gl.GetUniformLocation(program, sampler.name.c_str()), sampler.unit);
}

void upload(const Gl& gl, int width, int height, const void* texels, bool repeats) {
    unsigned texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    const int wrap = repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, repeats ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    if (repeats)
        gl.GenerateMipmap(GL_TEXTURE_2D);
}

void bindTextures(const Gl& gl, const Interface& interface, const Json& files) {
    for (const Sampler& sampler : interface.samplers) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(sampler.unit));
        if (files.contains(sampler.name)) {
            const Json& file = files[sampler.name];
            std::ifstream in(file["file"].get<std::string>(), std::ios::binary);
            const std::string texels(std::istreambuf_iterator<char>(in), {});
            upload(gl, file["width"], file["height"], texels.data(), false);
        } else {
            makeTexture(static_cast<unsigned>(findTextureRole(sampler.name)->role));
            const Json made = answer();
            upload(gl, made["width"], made["height"], at<std::uint8_t>(made["rgba"]), true);
        }
    }
}

struct Stream {
    const char* array;
    int floats;
};
const std::map<std::string, Stream> kStreams = {{"aPosition", {"positions", 3}},
                                                {"aNormal", {"normals", 3}},
                                                {"aTangent", {"tangents", 4}},
                                                {"aUv0", {"uv0", 2}},
                                                {"aUv1", {"uv1", 2}},
                                                {"aColor", {"colors", 4}}};

void drawSphere(const Gl& gl, const Interface& interface) {
    makeSphere(kRings);
    const Json sphere = answer();
    for (const Attribute& each : interface.attributes) {
        const Stream& stream = kStreams.at(each.name);
        const Json& array = sphere[stream.array];
        unsigned buffer = 0;
        gl.GenBuffers(1, &buffer);
        gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl.BufferData(GL_ARRAY_BUFFER, array[1].get<long>() * 4, at<float>(array), GL_STATIC_DRAW);
        gl.EnableVertexAttribArray(static_cast<unsigned>(each.location));
        gl.VertexAttribPointer(static_cast<unsigned>(each.location), stream.floats, GL_FLOAT, GL_FALSE, 0,
                               nullptr);
    }
    // Its vertices are few enough for 16 bits, which every GLES2 draws.
    const std::uint32_t* const indices = at<std::uint32_t>(sphere["indices"]);
    const auto count = sphere["indices"][1].get<int>();
    std::vector<std::uint16_t> shorter(static_cast<std::size_t>(count));
    std::transform(indices, indices + count, shorter.begin(),
                   [](std::uint32_t index) { return static_cast<std::uint16_t>(index); });
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, shorter.data());
}

void draw(const Gl& gl, const Json& job) {
    const Result<Canonical> canonical = parseName(job["name"].get<std::string>()).and_then(canonicalise);
    if (!canonical)
        fail(toString(canonical.error()));
    const Composed composed = compose(canonical->permutation);
    const unsigned program = link(gl, composed);
    gl.UseProgram(program);
    setUniforms(gl, program, composed.interface, job);
    bindTextures(gl, composed.interface, job["textures"]);
    const std::vector<float> background = job["background"];
    gl.ClearColor(background[0], background[1], background[2], 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    drawSphere(gl, composed.interface);
    if (gl.GetError() != GL_NO_ERROR)
        fail("GL reports an error");
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3)
        fail("usage: web_reference JOB.json OUT.rgba");
    std::ifstream in(argv[1]);
    const Json job = Json::parse(in, nullptr, false);
    if (job.is_discarded())
        fail(std::string(argv[1]) + ": no JSON");
    const Result<test::Offscreen> offscreen =
        test::openOffscreen(platform::Backend::OsMesa, {job["width"], job["height"]});
    if (!offscreen)
        fail(toString(offscreen.error()));
    draw(offscreen->gl, job);
    std::vector<char> pixels(job["width"].get<std::size_t>() * job["height"].get<std::size_t>() * 4);
    offscreen->gl.BindFramebuffer(GL_FRAMEBUFFER, offscreen->surface->framebuffer());
    offscreen->gl.ReadPixels(0, 0, job["width"], job["height"], GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream(argv[2], std::ios::binary)
        .write(pixels.data(), static_cast<std::streamsize>(pixels.size()));
}
