// SPDX-License-Identifier: MIT
#pragma once

#include "franken/draw_state.h"
#include "franken/draw_target.h"
#include "franken/gl_object.h"
#include "franken/gl_state.h"
#include "franken/program_cache.h"
#include "probe_triangle.h"
#include "texture_reset.h"

#include <map>
#include <optional>
#include <span>

namespace franken {

/// Draws one pixel with a program, as the renderer would draw a surface with it, and looks whether it has the
/// colour that it should have. Uniforms and textures are such that every program has something to draw: alpha
/// is 1, the cutoff 0. Textures are of two by two texels; drivers compile for their formats and wraps, not
/// for their sizes.
class ProgramProbe {
public:
    struct Draw {
        const Permutation* permutation;
        ShaderProgram* program;
        const DrawState* state;
    };

    /// ownSnippets: programs are of an application's snippets, and may draw anything. The table and the reset
    /// must outlive it. GL objects are made when they are needed first.
    ProgramProbe(const Gl& gl, TextureReset& reset, Log log, bool ownSnippets);

    /// Draws all of them, side by side, and says of each whether its pixel is right (expected_pixel.h), or
    /// whether it changed, for snippets of others. Without a target, into one of its own; into that as well
    /// where the target cannot be read back, as one with several samples a pixel that is not resolved. The
    /// target's contents are undefined afterwards.
    std::vector<bool> draw(std::span<const Draw> draws, const DrawTarget* target);

private:
    using Pixel = std::array<std::uint8_t, 4>;
    using Pixels = std::vector<Pixel>;
    using Row = std::span<const Draw>;

    DrawTarget ownTarget();
    const ProbeTriangle& triangle();
    const GlTexture& texture(Type type, DrawState::Wraps wraps);
    void bindTextures(const Draw& draw);
    /// Nothing where the target cannot be read back: two clears look the same.
    std::optional<std::vector<bool>> drawRows(Row draws, const DrawTarget& target);
    std::optional<std::vector<bool>> drawRow(Row row);
    bool isRight(const Draw& draw, const Pixel& before, const Pixel& after) const;
    Pixels clear(const Float3& color, std::size_t count);
    Pixels read(std::size_t count) const;
    void drawOne(const Draw& draw, GLint x);

    const Gl* m_gl;
    TextureReset* m_reset;
    Log m_log;
    GlState m_state;
    std::optional<ProbeTriangle> m_triangle;
    std::map<std::tuple<Type, Wrap, Wrap>, GlTexture> m_textures;
    GlTexture m_color;
    GlRenderbuffer m_depth;
    GlFramebuffer m_framebuffer;
    UniformBlock<FrameBlock> m_frame;
    UniformBlock<LightsBlock> m_lights, m_lightsFp16;
    UniformBlock<MaterialBlock> m_material;
    UniformBlock<ObjectBlock> m_object;
    UniformBlock<SkinBlock> m_skin; ///< All joints where they were bound.
    UniformBlock<EffectBlock> m_effect;
    bool m_ownSnippets;
    bool m_saidThatItIsBlind = false;
};

} // namespace franken
