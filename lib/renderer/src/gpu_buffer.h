// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_object.h"
#include "franken/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace franken {

/// "gl.object": the driver returned no name for a new object.
Error noObject(const char* kind);

/// A new buffer, bound to `target`; with the bytes, unless there are none. Fails with "gl.object".
Result<GlBuffer> uploadBuffer(const Gl& gl, GLenum target, std::span<const std::byte> bytes);

/// A buffer that is filled in parts.
class BufferUpload {
public:
    /// Fails with "gl.object".
    static Result<BufferUpload> begin(const Gl& gl, GLenum target, std::vector<std::uint8_t> bytes);

    bool isDone() const { return m_done; }
    /// Uploads what there are bytes for, and returns how many. Leaves the buffer bound.
    std::size_t step(const Gl& gl, std::size_t maxBytes);
    GlBuffer take() { return std::move(m_buffer); }

private:
    BufferUpload(GlBuffer buffer, GLenum target, std::vector<std::uint8_t> bytes)
        : m_buffer(std::move(buffer)), m_target(target), m_bytes(std::move(bytes)) {}

    GlBuffer m_buffer;
    GLenum m_target;
    std::vector<std::uint8_t> m_bytes;
    std::size_t m_offset = 0;
    bool m_done = false;
};

} // namespace franken
