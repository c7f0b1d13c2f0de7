// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/gl.h"
#include "franken/result.h"

/// Contexts that die in silence: calls do nothing then, and functions that return or write something do not.
namespace FRANKEN_API franken {

/// "renderer.context-lost"
Error contextLost();

/// Whether the context still answers questions. Asks GL: not for a frame.
bool answers(const Gl& gl);

/// Reads GL's errors, a bounded number of them. Fails with "renderer.memory" for GL_OUT_OF_MEMORY, and with
/// "renderer.context-lost" where the context has gone or its errors have no end; with `refused`, where it is
/// given, for GL_INVALID_OPERATION. Other errors are bugs.
Result<void> checkErrors(const Gl& gl, const Error* refused = nullptr);

} // namespace franken
