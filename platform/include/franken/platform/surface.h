// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/log.h"
#include "franken/platform/rotation.h"
#include "franken/platform/screen.h"
#include "franken/result.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace franken {
namespace FRANKEN_API platform {

/// From the full name of a GL function ("glClear") to its address, or null where the driver knows none. An
/// address does not prove that the function is there (Mesa makes one up for any name): GL_VERSION and
/// GL_EXTENSIONS tell.
using GetProcAddress = std::function<void*(const char* name)>;

/// Most samples a pixel that can be asked for. vc4 and v3d have 4.
inline constexpr int kMaxSamples = 16;

/// Largest width and height that a surface is made with, in pixels: a 4K screen supersampled 2x2, in 256 MiB.
/// Drivers with a lower limit refuse by themselves (vc4: 2048).
inline constexpr int kMaxSurfaceSize = 8192;

/// Where a surface comes from.
enum class Backend {
    /// Mesa's software renderer, into this process's memory: needs no device and no privilege. It is an
    /// OpenGL compatibility context that takes GLES2 programs; osmesa.cpp lists the differences from GLES2.
    OsMesa,
    /// A GLES2 context with a pbuffer, through EGL without a window system: on a GPU's render node, or with
    /// Mesa's software driver.
    EglSurfaceless,
    /// A screen without a window system, through KMS (atomic), GBM and EGL: see ScreenOptions. The process
    /// must be allowed to open the nodes in /dev/dri (groups `video` and `render`), and no other process may
    /// be their master.
    Kms,
    /// A window on a desktop, by SDL2: for development.
    Window
};

/// What a surface is doing. Offscreen surfaces are Ready, or Busy between submit() and dispatch().
enum class SurfaceState {
    Ready,      ///< A frame can be begun.
    Busy,       ///< A frame is on its way to the screen, or the frame rate's limit delays it.
    NoScreen,   ///< No screen is connected, or the device is not there (yet): waits for it.
    Paused,     ///< Somebody else is master of the screen: waits until it is free.
    Blanked,    ///< blank() was asked for.
    Recovering, ///< The kernel refused a frame, temporarily: tries again in a moment.
    Failed ///< Nothing helped: failure() says why. End the process, so that a service manager restarts it.
};

/// "ready", "busy", "no screen", …
std::string_view toString(SurfaceState state);

/// A frame that was shown.
struct CompletedFrame {
    std::uint64_t sequence = 0;   ///< Of the screen's refresh; of the frame, for a surface without a screen.
    std::int64_t nanoseconds = 0; ///< When its first pixel was scanned out; CLOCK_MONOTONIC.
    /// Refreshes between the one that it was due at, the first after begin(), and the one that showed it. 0
    /// for a frame that follows more than a second without any: nothing moved that could have come late.
    int missed = 0;
};

/// What dispatch() found.
struct SurfaceEvents {
    std::optional<CompletedFrame> completed; ///< The last frame that reached the screen, if one did.
    bool stateChanged = false;               ///< state() may say another thing than before.
    /// Size, refresh rate, rotation, format, encoding or samples have changed.
    bool layoutChanged = false;
    /// All GL objects are lost, and the functions' addresses may have changed: load the functions and make
    /// the objects again. Also set for the first context, after a start without a device.
    bool contextReplaced = false;
    bool closeRequested = false; ///< The window's close button.
};

/// A copy of a picture.
struct ScreenPicture {
    Size size; ///< Of the target.
    std::vector<std::uint8_t>
        rgba; ///< 8 bits each; rows from the top down, as the screen has them: not turned upright.
};

/// A picture that a screen shows, or has shown, and that is kept as it is while the next frames are drawn.
class HeldPicture {
public:
    virtual ~HeldPicture() = default;

    /// Copies it, in any thread, without GL and without waiting for a frame; takes tens of milliseconds for a
    /// full screen of a Raspberry Pi. Fails with `surface.picture` where the driver does not let it be read,
    /// or where its buffers are gone by now: after another mode, another device, the surface's end, or where
    /// there was too little memory to draw the next frame without it.
    virtual Result<ScreenPicture> read() = 0;
};

/// How a screen is made dark.
enum class Blanking {
    None,
    Black, ///< The signal goes on, with a black picture.
    Off    ///< The signal ends (DPMS), and most screens go to sleep.
};

/// A GLES2 context and its default target: an image in memory, a window or a screen. The target is RGBA8 (or
/// format()) with a depth buffer, row 0 at the bottom.
///
/// Nothing blocks: the caller's loop polls descriptor() and calls dispatch() when it is readable. One frame
/// is on its way at a time:
///
///     if (*surface->begin()) {
///         draw();
///         surface->submit();
///     }
///     // Later, when the descriptor is readable:
///     const SurfaceEvents events = surface->dispatch();
///     // When events.completed is set, begin the next frame.
///
/// Offscreen surfaces complete a frame at once, so that the same loop serves all backends; a program that
/// only reads pictures back can draw whenever the surface is current.
///
/// Surfaces of several backends can live in one process and take turns in one thread: makeCurrent() takes
/// the thread away from whichever surface had it. A surface is used and destroyed by one thread at a time;
/// it must not be current in another. Destroying it leaves the thread's other current surface, if any, as it
/// was.
///
/// All GL functions come from getProcAddress(); do not link a GL library (two drivers in one process export
/// the same names). The addresses serve all surfaces of the same backend.
class Surface {
public:
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    virtual ~Surface() = default;

    /// What draws.
    Backend backend() const { return m_backend; }

    /// The driver's GL_RENDERER and GL_VERSION: "softpipe, OpenGL ES 3.1 Mesa 22.3.6".
    const std::string& driver() const { return m_driver; }

    /// Size of the target. It can change in dispatch(), which says so (a screen that is plugged in, a window
    /// that is dragged), and nowhere else.
    Size size() const { return m_size; }

    /// How the screen is mounted. The backend does not turn the picture: DrawTarget::rotation does (or a
    /// projection that is multiplied by clipRotation()); use turned(size(), rotation()) for the layout.
    Rotation rotation() const { return m_rotation; }

    /// Refreshes a second in thousandths; 0 for a surface without a screen.
    int refreshMilliHertz() const { return m_refreshMilliHertz; }

    /// The target's pixel format.
    PixelFormat format() const { return m_format; }

    /// Whether frames are shown.
    SurfaceState state() const { return m_state; }

    /// Whether the screen needs a frame although nothing moved: it shows none yet, or not this one's any more
    /// (after another mode, another master, a blanking, a reset; a window that was covered). Draw it once the
    /// state is Ready. A surface in memory never does.
    bool wantsFrame() const { return m_wantsFrame; }

    /// A description of the state, for people: the screen, its mode and format; the reason for waiting; or
    /// the last error.
    const std::string& status() const { return m_status; }

    /// The error after which state() became Failed.
    const Error& failure() const { return m_failure; }

    /// Whether there is a context. False only for a KMS surface whose device is not there.
    bool hasContext() const { return m_hasContext; }

    /// The GL name of the target's framebuffer; bind it to draw to the target. Usually 0 for a target that
    /// the window system owns, but do not rely on it.
    unsigned framebuffer() const { return m_framebuffer; }

    /// Whether the target encodes written colours (linear to sRGB), so that the shader must not. Only if
    /// SurfaceOptions::srgb requests it.
    bool srgbTarget() const { return m_srgbTarget; }

    /// The target's samples per pixel, for smooth edges; 0 without multisampling. Samples are averaged when
    /// the frame ends, as 8-bit values: not in linear light, unless the target encodes. glReadPixels returns
    /// the average as well, but with llvmpipe the first sample (Mesa 22.3.6).
    int samples() const { return m_samples; }

    /// The loader of GL functions; valid for as long as the surface lives.
    virtual GetProcAddress getProcAddress() const = 0;

    /// Makes the context current in this thread. Fails with `surface.driver` where the driver refuses. EGL
    /// does where another thread holds the context; OSMesa does not notice.
    Result<void> makeCurrent();

    /// A file descriptor that polls as readable when dispatch() has something to do. It belongs to the
    /// surface.
    virtual int descriptor() const = 0;

    /// Reads pending events; never waits. Call it when descriptor() is readable, or at any other time.
    virtual SurfaceEvents dispatch() = 0;

    /// Whether a frame may be drawn now; the context is current then. False in all states but Ready. Fails as
    /// makeCurrent() does.
    Result<bool> begin();

    /// Ends the frame that begin() allowed, and sends it to the screen; state() is Busy afterwards, until a
    /// dispatch() returns the frame as completed. The contents of the target are kept where it is an image in
    /// memory, and undefined on a screen. A frame that the screen's driver refuses is no error here: see
    /// state(). Fails with `surface.lost` when the context and all its GL objects are gone: make a new
    /// surface and rebuild them; with `surface.state` without a begin() before it.
    Result<void> submit();

    /// Keeps the picture of the last completed frame until what is returned is destroyed, in any thread: a
    /// copy of it costs no frame anything. Meanwhile one buffer more is in use, of the memory that the
    /// screen's buffers have (on a Raspberry Pi, the kernel's contiguous memory); so hold one at a time. Null
    /// where nothing is shown, and for all surfaces but those of KMS: read those with glReadPixels before
    /// submit().
    virtual std::shared_ptr<HeldPicture> holdShown() { return nullptr; }

    /// Makes the screen dark, or wakes it; after waking, the next completed frame proves that it shows again.
    /// Fails with `surface.unsupported` where there is no screen to blank.
    virtual Result<void> blank(Blanking blanking);

    /// pause() gives the screen to another program (on another virtual console), after the flip that is on
    /// its way; resume() takes it back. Without a screen, both do nothing.
    virtual void pause() {}
    virtual void resume() {}

    /// Switches the screen off and on with its mode: Watch::Step::ResetScreen. Without a screen, does
    /// nothing.
    virtual void resetScreen() {}

protected:
    /// For backends.
    Surface(Backend backend, Size size) : m_backend(backend), m_size(size) {}

    /// The backend's part of makeCurrent(), called with no other surface current in the thread.
    virtual Result<void> bind() = 0;

    /// Leaves the thread without a context.
    virtual void unbind() = 0;

    /// The backend's part of submit().
    virtual Result<void> finishFrame() = 0;

    /// Called by begin() before it returns true.
    virtual void frameBegun() {}

    /// unbind() if it is current in the thread. A backend's destructor begins with it.
    void letGo();

    /// makeCurrent(), then fills in driver(): the last step of opening a surface.
    Result<void> makeReady();

    /// What the functions of these names return; a backend keeps them.
    Backend m_backend;
    Size m_size;
    unsigned m_framebuffer = 0;
    bool m_srgbTarget = false;
    int m_samples = 0;
    std::string m_driver;
    Rotation m_rotation = Rotation::None;
    int m_refreshMilliHertz = 0;
    PixelFormat m_format = PixelFormat::Rgb8;
    SurfaceState m_state = SurfaceState::Ready;
    std::string m_status;
    Error m_failure;
    bool m_hasContext = true;
    bool m_wantsFrame = false;

private:
    bool m_begun = false;
};

/// How a surface is opened.
struct SurfaceOptions {
    Size size = {256, 256}; ///< Each 1 to kMaxSurfaceSize.
    bool srgb = false;      ///< Requests a target that encodes, where the driver has one: see srgbTarget().
    int depthBits = 24;     ///< A minimum, 0 to 32; 0 where no depth buffer is needed.

    /// The minimum of samples a pixel, 0 to kMaxSamples; no multisampling where the driver has no such
    /// target: see samples(). Of Mesa's software drivers only llvmpipe through EGL has multisampling, with 4
    /// samples (22.3.6; not 25.0.7, whose surfaces with samples hold no colours); softpipe and OSMesa have
    /// none.
    int samples = 0;

    Log log = {}; ///< Receives the name of the driver.

    /// A folder in which Mesa keeps compiled programs between starts (on v3d; vc4 cannot); empty: in
    /// ~/.cache. For a kiosk whose home folder is read-only or not persistent. Sets MESA_SHADER_CACHE_DIR for
    /// the process, unless the environment has it already. Mesa reads it when the driver's first context is
    /// made: set it in the first create(), before other threads run.
    std::string shaderCache = {};

    ScreenOptions screen = {}; ///< For Backend::Kms, which takes its size from the screen.
    std::string title = {};    ///< Of the window.
};

/// "osmesa", "egl", "kms" or "window".
std::string_view toString(Backend backend);

/// The inverse of toString(). Fails with `surface.backend`; the remedy lists the choices.
Result<Backend> parseBackend(std::string_view text);

/// Makes a surface of that backend and makes it current in this thread (after a failure, no surface may be
/// current). Any thread may call it. Fails with
/// - `surface.options` for a size, depth or number of samples out of range,
/// - `surface.not-installed` where the backend is not there at all: it names the Debian packages,
/// - `surface.driver` where a driver is missing or refuses: it names the call and its error,
/// - `surface.software` where a screen would be drawn by the processor, and ScreenOptions does not allow it,
/// - `screen.busy` where another process is the screen's master: it names the processes that hold the node,
/// - `screen.permission` where the nodes may not be opened: it names the groups.
/// A missing screen or device is no error: the surface waits for it in SurfaceState::NoScreen.
///
/// Mesa chooses the software rasteriser, by environment variables: GALLIUM_DRIVER=softpipe or llvmpipe for
/// both backends, LIBGL_ALWAYS_SOFTWARE=1 to keep EGL off a GPU. Mesa reads them once, when the first context
/// of a backend is made.
Result<std::unique_ptr<Surface>> create(Backend backend, const SurfaceOptions& options);

} // namespace platform
} // namespace franken
