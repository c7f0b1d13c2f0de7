// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/gl.h"

#include <type_traits>
#include <utility>

namespace FRANKEN_API franken {

/// Owns one GL name and deletes it at the end. Moves, does not copy; holds no name (0) when made without one
/// or moved from.
///
/// The context that made the name must be current where the object is destroyed or assigned to, and the table
/// must outlive it. After a lost context the name means nothing: release() it, and make a new one.
template<auto Delete>
class GlObject {
public:
    GlObject() = default;
    GlObject(const Gl& gl, GLuint name) : m_gl(&gl), m_name(name) {}
    GlObject(GlObject&& other) noexcept : m_gl(other.m_gl), m_name(other.release()) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(m_gl, other.m_gl);
        std::swap(m_name, other.m_name);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    ~GlObject() {
        if (m_name == 0)
            return;
        if constexpr (std::is_invocable_v<decltype(m_gl->*Delete), GLuint>)
            (m_gl->*Delete)(m_name);
        else
            (m_gl->*Delete)(1, &m_name);
    }

    GLuint name() const { return m_name; }
    explicit operator bool() const { return m_name != 0; }

    /// Gives the name up without deleting it.
    GLuint release() { return std::exchange(m_name, 0); }

private:
    const Gl* m_gl = nullptr;
    GLuint m_name = 0;
};

using GlBuffer = GlObject<&Gl::DeleteBuffers>;
using GlFramebuffer = GlObject<&Gl::DeleteFramebuffers>;
using GlProgram = GlObject<&Gl::DeleteProgram>;
using GlRenderbuffer = GlObject<&Gl::DeleteRenderbuffers>;
using GlShader = GlObject<&Gl::DeleteShader>;
using GlTexture = GlObject<&Gl::DeleteTextures>;

/// One new name from a function that generates many: `GlTexture texture(gl, generate(gl.GenTextures));`
inline GLuint generate(void(GL_APIENTRY* function)(GLsizei, GLuint*)) {
    GLuint name = 0;
    function(1, &name);
    return name;
}

} // namespace franken
