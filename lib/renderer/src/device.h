// SPDX-License-Identifier: MIT
#pragma once

#include "franken/capabilities.h"
#include "franken/draw_target.h"
#include "franken/gl_state.h"
#include "franken/gpu_memory.h"
#include "franken/log.h"
#include "franken/own_thread.h"

#include <cstdint>

namespace franken {

/// The context that a renderer draws in, and what its owners of GL objects share.
class Device {
public:
    Device(const Gl& table, const Capabilities& found, Log log_);

    /// The context is gone: from now on the table deletes names without a call, and does nothing else.
    void lost();
    /// Another context is current.
    void restore(const Gl& table, const Capabilities& found);

    /// From now on draws go to that area of the target, with all state that no draw sets at its baseline.
    void begin(const DrawTarget& target);

    OwnThread thread;
    Gl gl; ///< A copy, so that it can be replaced when the context is lost.
    Capabilities capabilities;
    const Log log;
    GlState state{gl};
    GpuMemory memory;
    bool isLost = false;

    /// Ticks with each frame and each change of what is shown; `frameBegan`: when the frame began. What was
    /// used since is not evicted.
    std::uint64_t clock = 1, frameBegan = 1;
};

} // namespace franken
