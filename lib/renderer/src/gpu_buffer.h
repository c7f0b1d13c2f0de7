// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl_object.h"
#include "franken/result.h"

#include <cstddef>
#include <span>

namespace franken {

/// "gl.object": the driver returned no name for a new object.
Error noObject(const char* kind);

/// A new buffer, bound to `target`; with the bytes, unless there are none. Fails with "gl.object".
Result<GlBuffer> uploadBuffer(const Gl& gl, GLenum target, std::span<const std::byte> bytes);

} // namespace franken
