// SPDX-License-Identifier: MIT
#include "renderer_state.h"

namespace franken {
namespace {

/// The table of a context that is gone: names are given up without a call.
Gl deadTable() {
    Gl gl;
    gl.DeleteBuffers = [](GLsizei, const GLuint*) {};
    gl.DeleteFramebuffers = [](GLsizei, const GLuint*) {};
    gl.DeleteRenderbuffers = [](GLsizei, const GLuint*) {};
    gl.DeleteTextures = [](GLsizei, const GLuint*) {};
    gl.DeleteProgram = [](GLuint) {};
    gl.DeleteShader = [](GLuint) {};
    return gl;
}

Error noSource() {
    return {"renderer.no-source", "", "a picture was lost with the context, and it has no source",
            "hand addPicture() a source that reads it again"};
}

} // namespace

void Renderer::contextLost() {
    State& state = *m_state;
    state.lost = true;
    state.gl = deadTable();
    for (const std::unique_ptr<Model>& model : state.models)
        model->gpu.reset();
    state.sky = {};
    state.skyMemory = {};
    state.skyTriangle = {};
    state.mirror.reset();
    for (Picture& picture : state.pictures)
        picture.texture = {};
    state.overlayVertices = {};
    state.overlayIndices = {};
    state.overlayProgram.reset();
    state.defaults.reset();
    state.skyProgram.reset();
    state.programs.abandon();
    state.glState.invalidate();
    state.opaque.clear();
    state.blended.clear();
    state.backToFront.clear();
    state.drawn = 0;
    state.resolved = false;
}

Result<void> Renderer::restore(const Gl& gl) { return restore(gl, Capabilities::query(gl)); }

Result<void> Renderer::restore(const Gl& gl, const Capabilities& capabilities) {
    State& state = *m_state;
    if (!state.lost)
        contextLost();
    state.lost = false;
    state.gl = gl;
    state.capabilities = capabilities;
    state.programs.setCapabilities(capabilities);
    state.defaults.emplace(state.gl);
    state.mirror.emplace(state.gl);
    Result<void> result;
    const auto keepFirst = [&](Result<void> next) {
        if (result && !next)
            result = std::move(next);
    };
    std::vector<Model*> list = state.shown;
    for (Model* model : list)
        keepFirst(state.makeResident(*model));
    std::erase_if(list, [](const Model* model) { return !model->gpu; });
    state.setShown(std::move(list));
    if (state.skySource) {
        const Result<SkyCube> cube = state.skySource();
        keepFirst(cube ? state.uploadBackdrop(*cube) : Result<void>(cube.error()));
    }
    if (state.mirrorSource) {
        const Result<SkyMirror> mirror = state.mirrorSource();
        keepFirst(mirror ? state.uploadMirror(*mirror) : Result<void>(mirror.error()));
    }
    for (const Picture& picture : state.pictures)
        if (!picture.source)
            keepFirst(noSource());
    return result;
}

} // namespace franken
