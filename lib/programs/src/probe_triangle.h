// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_object.h"
#include "franken/gl_state.h"

namespace franken {

/// A triangle that faces +Z and has every attribute, for draws whose picture nobody sees: in the formats of
/// kAttributeFormats, so that a driver compiles for them what it will draw with later.
class ProbeTriangle {
public:
    enum class Extent {
        Covering, ///< All of clip space; texture coordinates 0 to 1 on it.
        None,     ///< All corners in one place: no pixel is shaded.
    };

    /// Leaves buffer bindings changed. The table must outlive it.
    ProbeTriangle(const Gl& gl, Extent extent);

    /// With the program in use, whose attribute arrays are enabled.
    void draw(GlState& state, unsigned attributes) const;

private:
    const Gl* m_gl;
    GlBuffer m_vertices, m_indices;
};

} // namespace franken
