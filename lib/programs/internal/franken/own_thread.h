// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"

#include <cassert>
#include <thread>

namespace FRANKEN_API franken {

/// Remembers the thread that it was made in. Whatever calls GL belongs to the thread of its context: its
/// functions check() first. What needs no GL (compose(), loadGltf(), planMaterial(), reading a manifest) runs
/// in any thread, at the same time as a frame.
class OwnThread {
public:
    /// Asserts that this is the same thread: to call GL from another one is a bug of the caller.
    void check() const {
        assert(std::this_thread::get_id() == m_id && "called outside the thread of its GL context");
    }

private:
    std::thread::id m_id = std::this_thread::get_id();
};

} // namespace franken
