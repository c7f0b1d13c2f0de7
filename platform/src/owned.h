// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

namespace franken::platform {

template<auto free>
struct Freer {
    template<typename T>
    void operator()(T* pointer) const {
        free(pointer);
    }
};

/// What a C library returned, and frees by a function of its own.
template<typename T, auto free>
using Owned = std::unique_ptr<T, Freer<free>>;

} // namespace franken::platform
