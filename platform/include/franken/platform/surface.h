// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/log.h"
#include "franken/result.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace franken {
namespace FRANKEN_API platform {

/// From the full name of a GL function ("glClear") to its address, or null where the driver knows none. An
/// address does not prove that the function is there (Mesa makes one up for any name): GL_VERSION and
/// GL_EXTENSIONS tell.
using GetProcAddress = std::function<void*(const char* name)>;

struct Size {
    int width = 0;  ///< Pixels.
    int height = 0; ///< Pixels.
    bool operator==(const Size&) const = default;
};

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
    EglSurfaceless
};

/// A context that speaks GLES2, and the target that it draws to unless told otherwise: an image in memory
/// now, a screen later. The target is RGBA8 with a depth buffer, row 0 at the bottom.
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

    /// Size of the target. It can change in present(), and nowhere else (a screen that is plugged in).
    Size size() const { return m_size; }

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

    /// Ends the frame, and shows it where there is a screen. The surface must be current. The contents of the
    /// target are kept where it is an image in memory, and undefined on a screen. Fails with `surface.lost`
    /// when the context and all its GL objects are gone: make a new surface and rebuild them.
    virtual Result<void> present() = 0;

protected:
    Surface(Backend backend, Size size) : m_backend(backend), m_size(size) {}

    /// The backend's part of makeCurrent(), called with no other surface current in the thread.
    virtual Result<void> bind() = 0;

    /// Leaves the thread without a context.
    virtual void unbind() = 0;

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
};

/// "osmesa" or "egl".
std::string_view toString(Backend backend);

/// The inverse of toString(). Fails with `surface.backend`; the remedy lists the choices.
Result<Backend> parseBackend(std::string_view text);

/// Makes a surface of that backend, which is current in this thread afterwards (where it fails, none may be).
/// Any thread may call it. Fails with
/// - `surface.options` for a size, depth or number of samples out of range,
/// - `surface.not-installed` where the backend is not there at all: it names the Debian packages,
/// - `surface.driver` where a driver is missing or refuses: it names the call and its error.
///
/// Which software rasteriser draws is Mesa's choice, through its environment: GALLIUM_DRIVER=softpipe or
/// llvmpipe for both backends, LIBGL_ALWAYS_SOFTWARE=1 to keep EGL off a GPU. The variables are read once,
/// when the first context of a backend is made.
Result<std::unique_ptr<Surface>> create(Backend backend, const SurfaceOptions& options);

} // namespace platform
} // namespace franken
