// SPDX-License-Identifier: MIT
#include "loading.h"

#include <regex>

using namespace franken;

LoadOptions modelLimits(const Options& options) {
    return {.maxFileBytes = options.memoryBytes, .maxMemoryBytes = options.memoryBytes};
}

SkyLimits skyLimits(const Options& options) {
    return {.maxFileBytes = options.memoryBytes, .maxMemoryBytes = options.memoryBytes};
}

Error inShellWords(Error error) {
    static const std::regex kLimit("(the )?(LoadOptions|SkyLimits)(::\\w+)?");
    error.remedy = std::regex_replace(error.remedy, kLimit, "--memory");
    return error;
}
