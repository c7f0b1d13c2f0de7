// SPDX-License-Identifier: MIT
#include "gpu_buffer.h"

#include <algorithm>

namespace franken {

Error noObject(const char* kind) {
    return {"gl.object", "", std::string("the driver makes no ") + kind,
            "its memory may be used up, or the context may be gone"};
}

Result<GlBuffer> uploadBuffer(const Gl& gl, GLenum target, std::span<const std::byte> bytes) {
    GlBuffer buffer(gl, generate(gl.GenBuffers));
    if (!buffer)
        return noObject("buffer");
    gl.BindBuffer(target, buffer.name());
    if (!bytes.empty())
        gl.BufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    return buffer;
}

Result<BufferUpload> BufferUpload::begin(const Gl& gl, GLenum target, std::vector<std::uint8_t> bytes) {
    GlBuffer buffer(gl, generate(gl.GenBuffers));
    if (!buffer)
        return noObject("buffer");
    return BufferUpload(std::move(buffer), target, std::move(bytes));
}

std::size_t BufferUpload::step(const Gl& gl, std::size_t maxBytes) {
    const std::size_t count = std::min(maxBytes, m_bytes.size() - m_offset);
    const bool isWhole = count == m_bytes.size();
    gl.BindBuffer(m_target, m_buffer.name());
    if (m_offset == 0 && !m_bytes.empty())
        gl.BufferData(m_target, static_cast<GLsizeiptr>(m_bytes.size()), isWhole ? m_bytes.data() : nullptr,
                      GL_STATIC_DRAW);
    if (!isWhole)
        gl.BufferSubData(m_target, static_cast<GLintptr>(m_offset), static_cast<GLsizeiptr>(count),
                         m_bytes.data() + m_offset);
    m_offset += count;
    m_done = m_offset == m_bytes.size();
    return count;
}

} // namespace franken
