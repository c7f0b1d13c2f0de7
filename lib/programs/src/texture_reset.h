// SPDX-License-Identifier: MIT
#pragma once

#include "franken/program_cache.h"
#include "probe_triangle.h"

#include <optional>

namespace franken {

/// Stops vc4 and v3d from compiling an untextured program again for whatever textures the draw before left
/// bound.
///
/// Mesa updates a driver's textures only for programs that sample some, so that those of the draw before stay
/// in place; and vc4 and v3d compile a program for all textures in place, whether it samples them or not
/// (Mesa 25.0.7: vc4_setup_shared_key, v3d_setup_shared_key). So before such a program an invisible triangle
/// is drawn with a program that samples one texture, always in the same way. It has no area and shades no
/// pixel. Does nothing on other drivers: see Capabilities::compilesForStaleTextures.
class TextureReset {
public:
    /// The table must outlive it.
    explicit TextureReset(const Gl& gl) : m_gl(&gl) {}

    /// What to reset with; until then nothing happens. Leaves GL's bindings undefined.
    void setProgram(ProgramHandle program);
    bool hasProgram() const { return m_program != nullptr; }

    /// Before each draw, with its blending and depth state set. May change program, arrays and unit 0.
    void prepareFor(GlState& state, const ShaderProgram& next);

    /// Someone else drew.
    void invalidate() { m_done = false; }

private:
    const Gl* m_gl;
    ProgramHandle m_program;
    std::optional<ProbeTriangle> m_triangle;
    GlTexture m_texture;
    bool m_done = false; ///< Nothing was sampled since.
};

/// The program that it takes: one texture, and as little else as there is.
Permutation resetPermutation();

} // namespace franken
