// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/generator/compose.h"
#include "franken/gl.h"
#include "franken/uniform_block.h"

#include <array>
#include <vector>

namespace FRANKEN_API franken {

/// A linked program that uploads its uniforms. Locations are looked up once, after the link; feed() makes no
/// GL call for blocks that the program has seen. The destructor deletes the GL program; the context must be
/// current.
class ShaderProgram {
public:
    /// Takes ownership of a program that was linked from that interface, and sets its sampler units. Leaves
    /// the program in use. The table must outlive the object.
    ShaderProgram(const Gl& gl, GLuint program, Interface interface);
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;
    ~ShaderProgram();

    /// GL's name of it; stays owned.
    GLuint name() const { return m_name; }
    /// What it reads.
    const Interface& interface() const { return m_interface; }

    /// Bit n: the program reads the attribute at location n.
    unsigned attributes() const { return m_attributes; }

    /// Uploads the blocks that the program has not seen; a block without values is skipped. The program must
    /// be in use.
    void feed(const BlockViews& blocks);
    void feed(Block block, const BlockView& view); ///< Uploads one block.

    /// After a lost context: forgets the GL program without deleting it. It cannot be used any more.
    void lost() { m_name = 0; }

private:
    struct Slot {
        GLint location;
        Type type;
        int count;
        int offset; ///< In floats.
    };

    void addSlot(const Uniform& uniform);
    void upload(const Slot& slot, const float* values) const;

    const Gl* m_gl;
    GLuint m_name;
    Interface m_interface;
    unsigned m_attributes = 0;
    std::array<std::vector<Slot>, kBlocks> m_slots; ///< By Block.
    std::array<std::uint64_t, kBlocks> m_seen{};    ///< By Block.
};

} // namespace franken
