// SPDX-License-Identifier: MIT
#include "franken/platform/watch.h"

#include <GLES2/gl2.h>

#include <array>

namespace franken::platform {

// clang-format off
#define FRANKEN_HEALTH_FUNCTIONS(X)                                                                          \
    X(BindFramebuffer) X(BindRenderbuffer) X(Clear) X(ClearColor) X(ColorMask) X(Disable) X(Enable)           \
    X(FramebufferRenderbuffer) X(GenFramebuffers) X(GenRenderbuffers) X(GetBooleanv) X(GetError)              \
    X(GetFloatv) X(GetIntegerv) X(IsEnabled) X(ReadPixels) X(RenderbufferStorage)
// clang-format on

struct GpuHealth::Functions {
#define FRANKEN_HEALTH_MEMBER(name) decltype(&::gl##name) name; // NOLINT(bugprone-macro-parentheses)
    FRANKEN_HEALTH_FUNCTIONS(FRANKEN_HEALTH_MEMBER)
#undef FRANKEN_HEALTH_MEMBER
};

GpuHealth::GpuHealth(const GetProcAddress& getProcAddress) {
    const auto gl = std::make_shared<Functions>();
#define FRANKEN_HEALTH_LOAD(name) gl->name = reinterpret_cast<decltype(gl->name)>(getProcAddress("gl" #name));
    FRANKEN_HEALTH_FUNCTIONS(FRANKEN_HEALTH_LOAD)
#undef FRANKEN_HEALTH_LOAD
    m_gl = gl;
}

bool GpuHealth::canaryLives() {
    const Functions& gl = *m_gl;
    GLint framebuffer = 0, renderbuffer = 0;
    GLfloat clear[4] = {};
    GLboolean mask[4] = {};
    gl.GetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
    gl.GetIntegerv(GL_RENDERBUFFER_BINDING, &renderbuffer);
    gl.GetFloatv(GL_COLOR_CLEAR_VALUE, clear);
    gl.GetBooleanv(GL_COLOR_WRITEMASK, mask);
    const bool scissor = gl.IsEnabled(GL_SCISSOR_TEST) != GL_FALSE;
    if (m_framebuffer == 0) {
        gl.GenFramebuffers(1, &m_framebuffer);
        gl.GenRenderbuffers(1, &m_colour);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    if (m_turn == 0) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, m_colour);
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA4, 1, 1); // The one format that every GLES2 draws to.
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_colour);
        gl.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer));
    }
    ++m_turn; // Bits of it become full or no red, green and blue.
    const auto channel = [&](unsigned bit) { return (m_turn >> bit & 1u) != 0 ? 1.0f : 0.0f; };
    gl.Disable(GL_SCISSOR_TEST);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.ClearColor(channel(0), channel(1), channel(2), 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    std::array<GLubyte, 4> pixel = {};
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    gl.ClearColor(clear[0], clear[1], clear[2], clear[3]);
    gl.ColorMask(mask[0], mask[1], mask[2], mask[3]);
    if (scissor)
        gl.Enable(GL_SCISSOR_TEST);
    for (unsigned bit = 0; bit < 3; ++bit)
        if (pixel[bit] != (channel(bit) > 0 ? 255 : 0))
            return false;
    return true;
}

unsigned GpuHealth::takeError() {
    const unsigned first = m_gl->GetError();
    for (int more = 0; first != 0 && more < 8 && m_gl->GetError() != 0;)
        ++more; // Each kind is kept once; a lost context may answer forever.
    return first;
}

} // namespace franken::platform
