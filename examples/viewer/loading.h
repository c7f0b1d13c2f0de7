// SPDX-License-Identifier: MIT
#pragma once

#include "franken/environment.h"
#include "franken/gltf.h"
#include "options.h"

/// What --memory means for a model, and for a sky. A file may be as large as all that is made of it.
franken::LoadOptions modelLimits(const Options& options);
franken::SkyLimits skyLimits(const Options& options);

/// The error with a remedy for somebody at a shell, where the library's is to raise a limit of its own.
franken::Error inShellWords(franken::Error error);
