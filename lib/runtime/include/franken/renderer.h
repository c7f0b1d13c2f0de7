// SPDX-License-Identifier: MIT
#pragma once

#include "franken/capabilities.h"
#include "franken/environment.h"
#include "franken/gl.h"
#include "franken/light.h"
#include "franken/log.h"
#include "franken/material.h"
#include "franken/program_cache.h"
#include "franken/scene.h"
#include "franken/specular_sky.h"
#include "franken/viewpoint.h"

#include <array>
#include <memory>

namespace franken {

/// Where a picture goes.
struct DrawTarget {
    unsigned framebuffer = 0;            ///< A GL name; with a depth buffer.
    int width = 0, height = 0;           ///< Pixels; the viewport begins at the lower left corner.
    Float3 background{0, 0, 0};          ///< As the target stores it: encoded already, 0-1.
    std::array<int, 3> bits = {8, 8, 8}; ///< Of each colour channel: what dithering goes by.
};

/// Draws a scene: one pass, opaque and masked surfaces by program, then the sky, then blended surfaces back
/// to front.
///
/// Belongs to the thread of its context, which must be current in all calls and in the destructor. A frame
/// sets all GL state that it depends on and asks GL for none; the state it leaves behind is undefined.
class Renderer {
public:
    /// The table must outlive the renderer. Asks the context for its capabilities.
    explicit Renderer(const Gl& gl, Log log = {});
    Renderer(const Gl& gl, const Capabilities& capabilities, Log log = {});
    ~Renderer();

    /// Uploads a scene, in place of the one before. The scene is not needed afterwards. Warns of what is left
    /// out. Fails with "renderer.memory" where the GPU's does not suffice.
    Result<void> load(const Scene& scene);

    /// Shows a sky behind the scene, or none (null). It lights nothing: that is Lighting's matter.
    Result<void> setBackdrop(const SkyCube* cube);

    /// Takes what rough mirrors show of a sky, or nothing (null). Seen where Lighting::skySpecular asks for
    /// it; surfaces reflect no sky then while there is none here. Fails with "renderer.sky" where the atlas
    /// is larger than the GPU's textures, and with "renderer.memory".
    Result<void> setMirror(const SkyMirror* mirror);

    /// Free to change from frame to frame. New counts of lights, another kind of ambient light, and any other
    /// look need other programs, which the next frame or prepare() makes.
    void setLighting(const Lighting& lighting);
    void setLook(const Look& look);

    /// Makes the programs that the next frame needs, so that it compiles nothing. Fails as
    /// ProgramCache::get() does.
    Result<void> prepare();

    Result<void> draw(const Viewpoint& viewpoint, const DrawTarget& target);

    const ProgramCounters& programCounters() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
