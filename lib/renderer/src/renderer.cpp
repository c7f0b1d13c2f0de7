// SPDX-License-Identifier: MIT
#include "renderer_state.h"

#include <algorithm>

namespace franken {
namespace {

/// Whether one light may follow the other without other programs and other material blocks.
bool sameShape(const Lighting& a, const Lighting& b) {
    const auto spots = [](const Lighting& lighting) {
        return std::any_of(lighting.punctualLights.begin(), lighting.punctualLights.end(),
                           [](const PunctualLight& light) { return light.spot; });
    };
    return a.suns.size() == b.suns.size() && a.punctualLights.size() == b.punctualLights.size() &&
           spots(a) == spots(b) && a.ambient == b.ambient && a.reflection == b.reflection &&
           a.exposure == b.exposure;
}

} // namespace

Result<void> checkMemory(const Gl& gl) {
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR; error = gl.GetError())
        if (error == GL_OUT_OF_MEMORY)
            return Error{"renderer.memory", "", "the GPU's memory does not suffice",
                         "use smaller textures, or raise the memory that the GPU gets"};
    return {};
}

Renderer::State::State(const Gl& table, const Capabilities& found, Log log_)
    : gl(table), capabilities(found), log(std::move(log_)), defaults(gl), mirror(gl) {
    memory.setEvict([this] { return evictOne(); });
}

Renderer::Renderer(const Gl& gl, Log log) : Renderer(gl, Capabilities::query(gl), std::move(log)) {}

Renderer::Renderer(const Gl& gl, const Capabilities& capabilities, Log log)
    : m_state(std::make_unique<State>(gl, capabilities, std::move(log))) {}

Renderer::~Renderer() = default;

void Renderer::setLighting(const Lighting& lighting) {
    m_state->resolved = m_state->resolved && sameShape(m_state->lighting, lighting);
    m_state->lighting = lighting;
}

void Renderer::setLook(const Look& look) {
    m_state->look = look;
    m_state->overlayProgram.reset();
    m_state->resolved = false;
}

void Renderer::setSnippets(const SnippetSet& snippets) {
    m_state->programs.setSnippets(snippets);
    m_state->overlayProgram.reset();
    m_state->resolved = false;
}

Result<void> Renderer::draw(const Viewpoint& viewpoint, const DrawTarget& target) {
    State& state = *m_state;
    state.frameBegan = ++state.clock;
    state.programs.beginFrame();
    Result<void> resolved = state.resolvePrograms(&target);
    if (state.lost)
        return resolved;
    state.updateBlocks(viewpoint, target);
    state.beginFrame(target);
    state.drawOpaque();
    if (state.sky && state.skyProgram)
        state.drawBackdrop();
    state.drawBlended();
    return resolved;
}

void Renderer::invalidateState() {
    m_state->glState.invalidate();
    m_state->programs.invalidateState();
}

FrameCounters Renderer::frameCounters() const {
    const std::size_t all = m_state->opaque.size() + m_state->blended.size();
    return {.drawn = m_state->drawn, .culled = all - m_state->drawn};
}

GpuMemory& Renderer::memory() { return m_state->memory; }

} // namespace franken
