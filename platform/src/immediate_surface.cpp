// SPDX-License-Identifier: MIT
#include "backends.h"

namespace franken::platform {

Result<void> ImmediateSurface::finishFrame() {
    if (Result<void> swapped = swap(); !swapped)
        return swapped;
    m_state = SurfaceState::Busy;
    signal(m_event);
    return {};
}

SurfaceEvents ImmediateSurface::dispatch() {
    SurfaceEvents events;
    drain(m_event);
    if (m_state != SurfaceState::Busy)
        return events;
    m_state = SurfaceState::Ready;
    events.stateChanged = true;
    events.completed = CompletedFrame{++m_frames, monotonicNow().count(), 0};
    return events;
}

} // namespace franken::platform
