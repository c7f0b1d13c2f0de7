// SPDX-License-Identifier: MIT
#include "loading.h"

using namespace franken;

// Encoded: a picture needs the pixels of one image at a time, when it is uploaded.
LoadOptions modelLimits(const Options& options) {
    return {.maxFileBytes = options.memoryBytes,
            .maxMemoryBytes = options.memoryBytes,
            .images = ImageForm::Encoded};
}

SkyLimits skyLimits(const Options& options) {
    return {.maxFileBytes = options.memoryBytes, .maxMemoryBytes = options.memoryBytes};
}

Error inShellWords(Error error) {
    // The library ends with the name of its own limit, which a user of the viewer does not see.
    if (const std::size_t raise = error.remedy.find("raise "); raise != std::string::npos)
        error.remedy.replace(raise, std::string::npos, "raise --memory");
    return error;
}
