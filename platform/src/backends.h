// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/surface.h"

namespace franken::platform {

/// What create() chooses from, one .cpp each. The options are checked already.
Result<std::unique_ptr<Surface>> createOsMesa(const SurfaceOptions& options);
Result<std::unique_ptr<Surface>> createEglSurfaceless(const SurfaceOptions& options);

} // namespace franken::platform
