// SPDX-License-Identifier: MIT
#pragma once

#include "franken/draw_target.h"
#include "franken/program_manager.h"
#include "pictures.h"

#include <array>
#include <cstdint>
#include <vector>

namespace franken {

struct OverlayVertex {
    std::array<float, 3> position;
    std::array<float, 2> uv;
    std::array<std::uint16_t, 4> color;
};

/// Draws pictures on top of a frame.
class Overlay final : public GlOwner {
public:
    Overlay(Device& device, ProgramManager& programs) : m_device(device), m_programs(programs) {}

    /// Renderer::drawOverlay(), with pictures that are prepared.
    Result<void> draw(std::span<const OverlayQuad> quads, const Pictures& pictures, const Look& look,
                      const DrawTarget& target);
    /// The look or the snippets have changed: another program may be needed.
    void forgetProgram() { m_program.reset(); }

    void lost() override;
    Result<void> restore() override { return {}; }

private:
    Result<void> prepare(const Look& look);
    void begin(const DrawTarget& target);
    void drawQuads(std::span<const OverlayQuad> quads, const Pictures& pictures);

    Device& m_device;
    ProgramManager& m_programs;
    GlBuffer m_vertices, m_indices;
    ProgramHandle m_program;
    std::vector<OverlayVertex> m_drawn; ///< Of the running draw(); a member, so that frames allocate nothing.
    UniformBlock<MaterialBlock> m_material;
    UniformBlock<ObjectBlock> m_object;
};

} // namespace franken
