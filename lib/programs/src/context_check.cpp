// SPDX-License-Identifier: MIT
#include "franken/context_check.h"

namespace franken {
namespace {

constexpr GLenum kContextLost = 0x0507; // GL_CONTEXT_LOST of GL_KHR_robustness.

/// GL has five kinds of errors, and may keep one of each in each of its parts.
constexpr int kMostErrors = 64;

} // namespace

Error contextLost() {
    return {"renderer.context-lost", "", "the GL context is gone, or does not answer any more",
            "make a new context, and call restore()"};
}

bool answers(const Gl& gl) {
    GLint size = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    return size > 0 && gl.GetString(GL_VERSION) != nullptr;
}

Result<void> checkErrors(const Gl& gl, const Error* refused) {
    bool outOfMemory = false, invalid = false;
    for (int count = 0; count < kMostErrors; ++count) {
        const GLenum error = gl.GetError();
        if (error == kContextLost)
            return contextLost();
        if (error != GL_NO_ERROR) {
            outOfMemory = outOfMemory || error == GL_OUT_OF_MEMORY;
            invalid = invalid || error == GL_INVALID_OPERATION;
            continue;
        }
        if (outOfMemory)
            return Error{"renderer.memory", "", "the GPU's memory does not suffice",
                         "use smaller textures, or reserve more memory for the GPU"};
        if (invalid && refused != nullptr)
            return *refused;
        return {};
    }
    return contextLost();
}

} // namespace franken
