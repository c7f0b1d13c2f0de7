// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace franken {

/// A number that no other handle of the process bears, of another renderer's either. Safe on any thread.
template<typename Id>
Id newHandle() {
    static std::atomic<unsigned> last{0};
    return Id{++last};
}

} // namespace franken
