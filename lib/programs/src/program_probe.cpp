// SPDX-License-Identifier: MIT
#include "program_probe.h"

#include "expected_pixel.h"
#include "franken/context_check.h"
#include "franken/gl_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace franken {
namespace {

constexpr int kOwnSize = 16;
constexpr Float3 kFirst{0.25f, 0.5f, 0.75f}, kSecond{0.75f, 0.25f, 0.5f}; ///< Differ in each channel.

// Where an effect draws nothing with these, it is asked again with 0.
constexpr EffectBlock kAllOne{{{{1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}}}};

constexpr Float9 kIdentity3{1, 0, 0, 0, 1, 0, 0, 0, 1};
// What the vertices' places are in the world: all light comes from straight ahead.
constexpr float kTiny = 1.0f / 4096;
constexpr Float16 kPoint{kTiny, 0, 0, 0, 0, kTiny, 0, 0, 0, 0, kTiny, 0, 0, 0, 0, 1};
constexpr Float16 kIdentity4{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// All light comes from the eye, so that no formula is at its edge.
LightsBlock lightFromTheEye() {
    LightsBlock block{};
    constexpr float kPi = std::numbers::pi_v<float>;
    constexpr float kLight = ProbeScene::kLight;
    block.ambient = packEvenAmbient(ProbeScene::kAmbient);
    for (std::size_t i = 0; i < Permutation::kMaxLights; ++i) {
        packSun(block, i, {.direction = {0, 0, -1}, .illuminance = kPi * kLight}, 1);
        packPunctualLight(block, i, {.position = {0, 0, 2}, .intensity = 4 * kPi * kLight}, {0, 0, 2}, 1);
    }
    return block;
}

/// Alpha is 1, and the normal map flat.
constexpr MaterialFactors kMaterial{
    .baseColor = {ProbeScene::kBase[0], ProbeScene::kBase[1], ProbeScene::kBase[2], 1},
    .metallic = ProbeScene::kMetallic,
    .roughness = ProbeScene::kRoughness,
    .normalScale = 0,
    .emissive = {ProbeScene::kEmissive, ProbeScene::kEmissive, ProbeScene::kEmissive},
    .alphaCutoff = 0};

/// A level of a white texture, as wide as it is high.
void uploadWhite(const Gl& gl, GLenum target, GLint level, GLsizei size) {
    const std::vector<std::uint8_t> white(static_cast<std::size_t>(4 * size * size), 255);
    gl.TexImage2D(target, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
}

GlTexture boundTexture(const Gl& gl, GLenum target) {
    GlTexture texture(gl, generate(gl.GenTextures));
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(target, texture.name());
    return texture;
}

GlTexture whiteTexture(const Gl& gl, DrawState::Wraps wraps) {
    GlTexture texture = boundTexture(gl, GL_TEXTURE_2D);
    setSampling(gl, GL_TEXTURE_2D, wraps.s, wraps.t, Filter::Linear, Filter::LinearMipmapLinear);
    uploadWhite(gl, GL_TEXTURE_2D, 0, 2);
    uploadWhite(gl, GL_TEXTURE_2D, 1, 1);
    return texture;
}

GlTexture whiteCube(const Gl& gl) {
    GlTexture texture = boundTexture(gl, GL_TEXTURE_CUBE_MAP);
    setSampling(gl, GL_TEXTURE_CUBE_MAP, Wrap::ClampToEdge, Wrap::ClampToEdge, Filter::Linear,
                Filter::Linear);
    for (GLenum face = 0; face < 6; ++face)
        uploadWhite(gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 2);
    return texture;
}

} // namespace

ProgramProbe::ProgramProbe(const Gl& gl, TextureReset& reset, Log log, bool ownSnippets)
    : m_gl(&gl), m_reset(&reset), m_log(std::move(log)), m_state(gl), m_ownSnippets(ownSnippets) {
    m_frame.edit() = {.cameraPosition = {0, 0, 2},
                      .clipToSky = kIdentity3,
                      .skyRange = ProbeScene::kSkybox,
                      .reflectionScale = std::sqrt(ProbeScene::kAmbient),
                      .dither = {}};
    m_lights.edit() = lightFromTheEye();
    m_lightsFp16.edit() = m_lights.values();
    fitToFp16(m_lightsFp16.edit(), 2);
    m_object.edit() = {kIdentity4, kPoint, kIdentity3, kIdentity3};
    constexpr std::array<Float4, 3> kAtRest = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    std::size_t row = 0;
    for (Float4& values : m_skin.edit().joints)
        values = kAtRest[row++ % kAtRest.size()];
}

std::vector<bool> ProgramProbe::draw(std::span<const Draw> draws, const DrawTarget* target) {
    m_state.invalidate();
    m_state.setBaseline();
    m_state.setDepthTest(true);
    m_state.setCulling(false);
    m_state.setFrontFace(GL_CCW); // A double-sided surface of ours faces the eye, whatever was drawn before.
    if (target != nullptr)
        if (const auto drawn = drawRows(draws, *target))
            return *drawn;
    if (const auto drawn = drawRows(draws, ownTarget()))
        return *drawn;
    if (m_log && !std::exchange(m_saidThatItIsBlind, true))
        m_log(LogLevel::Warning, "no target can be read back: that programs draw is taken on trust");
    return std::vector<bool>(draws.size(), true);
}

std::optional<std::vector<bool>> ProgramProbe::drawRows(Row draws, const DrawTarget& target) {
    m_gl->BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    std::vector<bool> drawn;
    bool blind = false; // All rows are drawn all the same: drivers compile for the target.
    const auto width = static_cast<std::size_t>(std::max(target.width, 1));
    for (std::size_t begin = 0; begin < draws.size(); begin += width) {
        const auto row = drawRow(draws.subspan(begin, std::min(width, draws.size() - begin)));
        blind = blind || !row;
        if (row)
            drawn.insert(drawn.end(), row->begin(), row->end());
    }
    if (!blind)
        return drawn;
    (void)checkErrors(*m_gl); // Of reading what cannot be read: not for the application to find.
    return std::nullopt;
}

std::optional<std::vector<bool>> ProgramProbe::drawRow(Row row) {
    std::vector<bool> drawn(row.size(), true);
    const Pixels before = clear(kFirst, row.size());
    m_effect.edit() = kAllOne;
    for (std::size_t i = 0; i < row.size(); ++i)
        drawOne(row[i], static_cast<GLint>(i));
    const Pixels after = read(row.size());
    for (std::size_t i = 0; i < row.size(); ++i)
        drawn[i] = isRight(row[i], before[i], after[i]);
    if (std::find(drawn.begin(), drawn.end(), false) == drawn.end())
        return drawn;
    const Pixels again = clear(kSecond, row.size());
    if (again == before)
        return std::nullopt;
    m_effect.edit() = {};
    for (std::size_t i = 0; i < row.size(); ++i)
        if (!drawn[i])
            drawOne(row[i], static_cast<GLint>(i));
    const Pixels last = read(row.size());
    for (std::size_t i = 0; i < row.size(); ++i)
        drawn[i] = drawn[i] || isRight(row[i], again[i], last[i]);
    return drawn;
}

bool ProgramProbe::isRight(const Draw& draw, const Pixel& before, const Pixel& after) const {
    return m_ownSnippets || draw.permutation->effect.slot != 0 ? after != before
                                                               : isExpected(*draw.permutation, after);
}

ProgramProbe::Pixels ProgramProbe::clear(const Float3& color, std::size_t count) {
    m_state.setDepthWrites(true);
    m_state.setClearColor({color[0], color[1], color[2], 1});
    m_gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return read(count);
}

ProgramProbe::Pixels ProgramProbe::read(std::size_t count) const {
    Pixels pixels(count);
    m_gl->ReadPixels(0, 0, static_cast<GLsizei>(count), 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

void ProgramProbe::drawOne(const Draw& draw, GLint x) {
    const ProbeTriangle& shape = triangle();
    bindTextures(draw);
    m_state.setBlending(draw.state->blend);
    m_state.setDepthWrites(!draw.state->blend);
    m_gl->Viewport(x, 0, 1, 1);
    m_reset->invalidate();
    m_reset->prepareFor(m_state, *draw.program);
    m_material.edit() = packMaterial(kMaterial, draw.permutation->brdf, 1, draw.permutation->precision);
    m_state.useProgram(draw.program->name());
    const auto& lights = draw.permutation->precision == Precision::Fp16 ? m_lightsFp16 : m_lights;
    draw.program->feed(
        {m_frame.view(), lights.view(), m_material.view(), m_object.view(), m_skin.view(), m_effect.view()});
    m_state.enableArrays(draw.program->attributes());
    shape.draw(m_state, draw.program->attributes());
}

void ProgramProbe::bindTextures(const Draw& draw) {
    std::array<GLuint, kTextureUnits> names{}; // Uploading binds: all are there before the first is bound.
    const std::vector<Sampler>& samplers = draw.program->interface().samplers;
    for (const Sampler& sampler : samplers) {
        const auto unit = static_cast<std::size_t>(sampler.unit);
        names[unit] = texture(sampler.type, draw.state->wraps[unit]).name();
    }
    for (const Sampler& sampler : samplers)
        m_state.bindTexture(static_cast<unsigned>(sampler.unit),
                            sampler.type == Type::SamplerCube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D,
                            names[static_cast<std::size_t>(sampler.unit)]);
}

const GlTexture& ProgramProbe::texture(Type type, DrawState::Wraps wraps) {
    GlTexture& texture = m_textures[{type, wraps.s, wraps.t}];
    if (!texture) {
        texture = type == Type::SamplerCube ? whiteCube(*m_gl) : whiteTexture(*m_gl, wraps);
        m_state.invalidate();
    }
    return texture;
}

const ProbeTriangle& ProgramProbe::triangle() {
    if (!m_triangle) {
        m_triangle.emplace(*m_gl, ProbeTriangle::Extent::Covering);
        m_state.invalidate();
    }
    return *m_triangle;
}

DrawTarget ProgramProbe::ownTarget() {
    if (!m_framebuffer) {
        const Gl& gl = *m_gl;
        m_color = GlTexture(gl, generate(gl.GenTextures));
        gl.BindTexture(GL_TEXTURE_2D, m_color.name());
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kOwnSize, kOwnSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        m_depth = GlRenderbuffer(gl, generate(gl.GenRenderbuffers));
        gl.BindRenderbuffer(GL_RENDERBUFFER, m_depth.name());
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, kOwnSize, kOwnSize);
        m_framebuffer = GlFramebuffer(gl, generate(gl.GenFramebuffers));
        gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_color.name(), 0);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth.name());
        m_state.invalidate();
    }
    return {.framebuffer = m_framebuffer.name(), .width = kOwnSize, .height = kOwnSize};
}

} // namespace franken
