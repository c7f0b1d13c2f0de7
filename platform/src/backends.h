// SPDX-License-Identifier: MIT
#pragma once

#include "descriptor.h"
#include "franken/platform/surface.h"

namespace franken::platform {

/// What create() chooses from, one .cpp each. The options are checked already.
Result<std::unique_ptr<Surface>> createOsMesa(const SurfaceOptions& options);
Result<std::unique_ptr<Surface>> createEglSurfaceless(const SurfaceOptions& options);
Result<std::unique_ptr<Surface>> createKms(const SurfaceOptions& options);
Result<std::unique_ptr<Surface>> createWindow(const SurfaceOptions& options);

/// A surface without a screen to wait for: what is submitted is complete at once.
class ImmediateSurface : public Surface {
public:
    using Surface::Surface;
    int descriptor() const override { return m_event.get(); }
    SurfaceEvents dispatch() override;

protected:
    /// The backend's end of a frame.
    virtual Result<void> swap() = 0;
    Result<void> finishFrame() override;

private:
    FileDescriptor m_event = makeEvent();
    std::uint64_t m_frames = 0;
};

} // namespace franken::platform
