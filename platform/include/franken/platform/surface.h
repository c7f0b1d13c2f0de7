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

namespace franken {
namespace FRANKEN_API platform {

/// From the full name of a GL function ("glClear") to its address, or null where the driver knows none. An
/// address does not prove that the function is there (Mesa makes one up for any name): GL_VERSION and
/// GL_EXTENSIONS tell.
using GetProcAddress = std::function<void*(const char* name)>;

/// Most samples a pixel that can be asked for. vc4 and v3d have 4.
inline constexpr int kMaxSamples = 16;

/// Largest width and height that a surface is made with, in pixels: a 4K screen supersampled 2x2, in 256 MiB.
/// A driver that takes less refuses on its own (vc4: 2048).
inline constexpr int kMaxSurfaceSize = 8192;

/// Where a surface comes from.
enum class Backend {
    /// Mesa's software renderer into this process' memory: needs no device and no privilege. An OpenGL
    /// compatibility context that takes GLES2 programs; what differs from GLES2 is noted in osmesa.cpp.
    OsMesa,
    /// A GLES2 context with a pbuffer, by EGL without a window system: on a GPU's render node, or by Mesa's
    /// software driver.
    EglSurfaceless,
    /// A screen without a window system, by KMS (atomic), GBM and EGL: see ScreenOptions. Needs the right to
    /// open the nodes in /dev/dri (groups `video` and `render`), and that nobody else is their master.
    Kms,
    /// A window on a desktop, by SDL2: for development.
    Window
};

/// What a surface is doing. Offscreen surfaces are Ready, or Busy between submit() and dispatch().
enum class SurfaceState {
    Ready,      ///< A frame can be begun.
    Busy,       ///< A frame is on its way to the screen, or the frame rate's limit is waited out.
    NoScreen,   ///< Nothing is connected, or the device is not there (yet): waits for it.
    Paused,     ///< Somebody else is master of the screen: waits until it is free.
    Blanked,    ///< blank() was asked for.
    Recovering, ///< The kernel refused a frame for want of something: tries again in a moment.
    Failed ///< Nothing helped: failure() says why. End the process, so that a service manager restarts it.
};

/// "ready", "busy", "no screen", …
std::string_view toString(SurfaceState state);

/// A frame that was shown.
struct CompletedFrame {
    std::uint64_t sequence = 0;   ///< Of the screen's refresh; of the frame, for a surface without one.
    std::int64_t nanoseconds = 0; ///< When its first pixel was scanned out; CLOCK_MONOTONIC.
    int missed = 0; ///< Refreshes between the one that it was due at and the one that showed it.
};

/// What dispatch() found.
struct SurfaceEvents {
    std::optional<CompletedFrame> completed;
    bool stateChanged = false;
    /// Size, refresh rate, rotation, format, encoding or samples are others than before.
    bool layoutChanged = false;
    /// All GL objects are gone, and the functions may be others: load the functions, make the objects again.
    /// Also when a context is there for the first time, after a start without a device.
    bool contextReplaced = false;
    bool closeRequested = false; ///< The window's close button.
};

/// How a screen is made dark.
enum class Blanking {
    None,
    Black, ///< The signal goes on, with a black picture.
    Off    ///< The signal ends (DPMS), and most screens go to sleep.
};

/// A context that speaks GLES2, and the target that it draws to unless told otherwise: an image in memory, a
/// window or a screen. The target is RGBA8 (or what format() says) with a depth buffer, row 0 at the bottom.
///
/// Nothing blocks, and there is no loop in here: the caller's loop polls descriptor() and calls dispatch()
/// when it is readable. One frame is on its way at a time:
///
///     if (*surface->begin()) { draw(); surface->submit(); }       // … later, when the descriptor is
///     readable: const SurfaceEvents events = surface->dispatch();           // events.completed: begin the
///     next one
///
/// Offscreen surfaces complete a frame at once, so that one loop serves all; who only reads pictures back can
/// draw whenever the surface is current.
///
/// Surfaces of several backends can live in one process and take turns in one thread: makeCurrent() takes
/// the thread away from whichever surface had it. A surface is used and destroyed by one thread at a time;
/// it must not be current in another. Destroying it leaves the thread's other current surface, if any, as it
/// was.
///
/// Everything about GL comes from getProcAddress(); no GL library is linked, and none must be (two drivers in
/// one process export the same names). The addresses serve all surfaces of the same backend.
class Surface {
public:
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    virtual ~Surface() = default;

    Backend backend() const { return m_backend; }

    /// What draws, as the driver puts it: GL_RENDERER and GL_VERSION, "softpipe, OpenGL ES 3.1 Mesa 22.3.6".
    const std::string& driver() const { return m_driver; }

    /// Size of the target. It can change in dispatch(), which says so (a screen that is plugged in, a window
    /// that is dragged), and nowhere else.
    Size size() const { return m_size; }

    /// How the screen is mounted. The backend does not turn the picture: multiply the projection with
    /// clipRotation(), and lay out for turned(size(), rotation()).
    Rotation rotation() const { return m_rotation; }

    /// Refreshes a second in thousandths; 0 for a surface without a screen.
    int refreshMilliHertz() const { return m_refreshMilliHertz; }

    /// What the target holds.
    PixelFormat format() const { return m_format; }

    SurfaceState state() const { return m_state; }

    /// Why the state is what it is, for people: the screen, its mode and format; what is waited for; or the
    /// last error.
    const std::string& status() const { return m_status; }

    /// The error that ended it; where state() is Failed.
    const Error& failure() const { return m_failure; }

    /// Whether there is a context. False only for a KMS surface whose device is not there.
    bool hasContext() const { return m_hasContext; }

    /// The GL name of the target's framebuffer: what to bind in order to draw to it. 0 for a target that the
    /// window system owns, but not to be taken for granted.
    unsigned framebuffer() const { return m_framebuffer; }

    /// Whether the target encodes what is written to it (linear to sRGB), so that the shader must not. Only
    /// where SurfaceOptions::srgb asked for it.
    bool srgbTarget() const { return m_srgbTarget; }

    /// How many samples the target has for each pixel, so that edges are smooth; 0 without multisampling.
    /// Samples are averaged when the frame ends, as codes: not in linear light, unless the target encodes.
    /// What glReadPixels returns is the average as well, but with llvmpipe the first sample (Mesa 22.3.6).
    int samples() const { return m_samples; }

    /// Where the functions come from; good for as long as the surface lives.
    virtual GetProcAddress getProcAddress() const = 0;

    /// Makes the context current in this thread. Fails with `surface.driver` where the driver refuses. EGL
    /// does where another thread holds the context; OSMesa does not notice.
    Result<void> makeCurrent();

    /// A file descriptor that polls as readable when dispatch() has something to do. It belongs to the
    /// surface.
    virtual int descriptor() const = 0;

    /// Reads what happened; never waits. Call it when descriptor() is readable, and as often as you like.
    virtual SurfaceEvents dispatch() = 0;

    /// Whether a frame may be drawn now; the context is current then. False in all states but Ready. Fails as
    /// makeCurrent() does.
    Result<bool> begin();

    /// Ends the frame that begin() allowed, and hands it to the screen; state() is Busy afterwards, until a
    /// dispatch() returns the frame as completed. The contents of the target are kept where it is an image in
    /// memory, and undefined on a screen. What the screen's driver refuses is no error here: state() tells.
    /// Fails with `surface.lost` when the context and all its GL objects are gone: make a new surface and
    /// rebuild them; with `surface.state` without a begin() before it.
    Result<void> submit();

    /// Makes the screen dark, or wakes it: then the next frame that is completed proves that it shows again.
    /// Fails with `surface.unsupported` where there is no screen to blank.
    virtual Result<void> blank(Blanking blanking);

    /// Gives the screen to somebody else (another virtual console), after the flip that is on its way, and
    /// takes it back. Nothing happens where there is no screen to give.
    virtual void pause() {}
    virtual void resume() {}

    /// Switches the screen off and on with its mode, as after a fault: a step of Watch's ladder. Nothing
    /// happens where there is no screen.
    virtual void resetScreen() {}

protected:
    Surface(Backend backend, Size size) : m_backend(backend), m_size(size) {}

    /// The backend's part of makeCurrent(), called with no other surface current in the thread.
    virtual Result<void> bind() = 0;

    /// Leaves the thread without a context.
    virtual void unbind() = 0;

    /// The backend's part of submit().
    virtual Result<void> finishFrame() = 0;

    /// What begin() does before it says yes.
    virtual void frameBegun() {}

    /// unbind() if it is current in the thread. A backend's destructor begins with it.
    void letGo();

    /// makeCurrent(), then fills in driver(): the last step of opening a surface.
    Result<void> makeReady();

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

private:
    bool m_begun = false;
};

struct SurfaceOptions {
    Size size = {256, 256}; ///< Each 1 to kMaxSurfaceSize.
    bool srgb = false;      ///< A target that encodes, where the driver has one: see srgbTarget().
    int depthBits = 24;     ///< At least so many, 0 to 32; 0 where no depth buffer is needed.

    /// At least so many samples a pixel, 0 to kMaxSamples, where the driver has such targets; without
    /// multisampling where it has none: see samples(). Of Mesa's software drivers llvmpipe has 4 by EGL;
    /// softpipe has none, nor has OSMesa, whatever draws.
    int samples = 0;

    Log log = {}; ///< Told which driver was found.

    /// A folder where Mesa keeps compiled programs from one start to the next (v3d does, vc4 cannot); empty:
    /// in ~/.cache. For a kiosk whose home cannot be written, or is not kept. Goes to MESA_SHADER_CACHE_DIR,
    /// unless the environment has that already. It is set for the process, and counts where the driver's
    /// first context is made: set it in the first create(), before other threads run.
    std::string shaderCache = {};

    ScreenOptions screen = {}; ///< For Backend::Kms, which takes its size from the screen.
    std::string title = {};    ///< Of the window.
};

/// "osmesa", "egl", "kms" or "window".
std::string_view toString(Backend backend);

/// The inverse of toString(). Fails with `surface.backend`; the remedy lists the choices.
Result<Backend> parseBackend(std::string_view text);

/// Makes a surface of that backend, which is current in this thread afterwards (where it fails, none may be).
/// Any thread may call it. Fails with
/// - `surface.options` for a size, depth or number of samples out of range,
/// - `surface.not-installed` where the backend is not there at all: it names the Debian packages,
/// - `surface.driver` where a driver is missing or refuses: it names the call and its error,
/// - `surface.software` where a screen would be drawn by the processor, and ScreenOptions does not allow it,
/// - `screen.busy` where another process is the screen's master: it names the processes that hold the node,
/// - `screen.permission` where the nodes may not be opened: it names the groups.
/// No screen, or no device yet, is no error: the surface waits for it in SurfaceState::NoScreen.
///
/// Which software rasteriser draws is Mesa's choice, through its environment: GALLIUM_DRIVER=softpipe or
/// llvmpipe for both backends, LIBGL_ALWAYS_SOFTWARE=1 to keep EGL off a GPU. The variables are read once,
/// when the first context of a backend is made.
Result<std::unique_ptr<Surface>> create(Backend backend, const SurfaceOptions& options);

} // namespace platform
} // namespace franken
