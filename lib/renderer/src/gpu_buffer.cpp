// SPDX-License-Identifier: MIT
#include "gpu_buffer.h"

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

} // namespace franken
