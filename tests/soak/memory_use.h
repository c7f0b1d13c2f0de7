// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace franken::test {

/// What the process holds at one moment; bytes.
struct MemoryUse {
    double seconds = 0;       ///< Since the run began.
    std::size_t resident = 0; ///< RSS.
    std::size_t heap = 0;     ///< Allocated and not freed, by anyone: C and C++, drivers included.
    std::size_t cpp = 0;      ///< Of these, by operator new: this project and tinygltf. Mesa's softpipe is C.
    std::size_t descriptors = 0; ///< Open files; a count.
};

MemoryUse memoryUse(double seconds);

/// The slope of RSS, of the heap or of any other member by least squares over all samples, in bytes a second.
double slope(const std::vector<MemoryUse>& samples, std::size_t MemoryUse::*member);

} // namespace franken::test
