// SPDX-License-Identifier: MIT
//
// A window on a desktop, to develop with. SDL2 is opened at run time and kept to ourselves, as OSMesa is: a
// kiosk on a Pi need not install it.
#include "backends.h"
#include "shared_library.h"

#ifdef FRANKEN_SDL

#include <SDL.h>

namespace franken::platform {

namespace {

constexpr const char* kLibrary = "libSDL2-2.0.so.0";
constexpr const char* kInstall = "install the Debian package libsdl2-2.0-0, or choose another backend";
constexpr Nanoseconds kPoll{16'666'667}; ///< SDL has no descriptor: its events are looked for so often.

// clang-format off
#define FRANKEN_SDL_FUNCTIONS(X)                                                                             \
    X(SetMainReady) X(InitSubSystem) X(QuitSubSystem) X(GetError) X(CreateWindow) X(DestroyWindow) X(SetHint)  \
    X(GL_SetAttribute) X(GL_GetAttribute) X(GL_CreateContext) X(GL_DeleteContext) X(GL_MakeCurrent)            \
    X(GL_SwapWindow) X(GL_GetProcAddress) X(GL_GetDrawableSize) X(GL_SetSwapInterval) X(PollEvent)              \
    X(GetWindowDisplayIndex) X(GetCurrentDisplayMode)
// clang-format on

struct Sdl {
#define FRANKEN_SDL_MEMBER(name) decltype(&::SDL_##name) name = nullptr; // NOLINT(bugprone-macro-parentheses)
    FRANKEN_SDL_FUNCTIONS(FRANKEN_SDL_MEMBER)
#undef FRANKEN_SDL_MEMBER
    static Result<Sdl> open();
};

Result<Sdl> Sdl::open() {
    Result<SharedLibrary> file = SharedLibrary::open(kLibrary, kInstall);
    if (!file)
        return file.error();
    Sdl sdl;
#define FRANKEN_SDL_FIND(name) file->find(sdl.name, "SDL_" #name);
    FRANKEN_SDL_FUNCTIONS(FRANKEN_SDL_FIND)
#undef FRANKEN_SDL_FIND
    if (Result<void> found = file->found(); !found)
        return found.error();
    return sdl;
}

class SdlWindow final : public Surface {
public:
    SdlWindow(const Sdl& sdl, Size size) : Surface(Backend::Window, size), m_sdl(sdl) {}
    ~SdlWindow() override;

    Result<void> open(const SurfaceOptions& options);
    GetProcAddress getProcAddress() const override { return m_sdl.GL_GetProcAddress; }
    int descriptor() const override { return m_timer.get(); }
    SurfaceEvents dispatch() override;

protected:
    Result<void> finishFrame() override;
    Result<void> bind() override;
    void unbind() override { m_sdl.GL_MakeCurrent(m_window, nullptr); }

private:
    Error failed(const char* call) const {
        return Error{"surface.driver", call, m_sdl.GetError(),
                     "start it on a desktop (DISPLAY or WAYLAND_DISPLAY must be set)"};
    }
    bool createWindow(const SurfaceOptions& options, int samples);

    Sdl m_sdl;
    SDL_Window* m_window = nullptr;
    SDL_GLContext m_context = nullptr;
    FileDescriptor m_timer = makeTimer();
    std::uint64_t m_frames = 0;
};

SdlWindow::~SdlWindow() {
    letGo();
    if (m_context != nullptr)
        m_sdl.GL_DeleteContext(m_context);
    if (m_window != nullptr)
        m_sdl.DestroyWindow(m_window);
    m_sdl.QuitSubSystem(SDL_INIT_VIDEO);
}

bool SdlWindow::createWindow(const SurfaceOptions& options, int samples) {
    m_sdl.GL_SetAttribute(SDL_GL_MULTISAMPLEBUFFERS, samples > 0);
    m_sdl.GL_SetAttribute(SDL_GL_MULTISAMPLESAMPLES, samples);
    const std::string title = options.title.empty() ? "FrankenShader" : options.title;
    m_window =
        m_sdl.CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                           options.size.width, options.size.height, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    return m_window != nullptr;
}

Result<void> SdlWindow::open(const SurfaceOptions& options) {
    m_sdl.SetMainReady();
    m_sdl.SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");
    m_sdl.SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (m_sdl.InitSubSystem(SDL_INIT_VIDEO) != 0)
        return failed("SDL_InitSubSystem");
    m_sdl.GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    m_sdl.GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 2);
    m_sdl.GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    m_sdl.GL_SetAttribute(SDL_GL_DEPTH_SIZE, options.depthBits);
    if (!createWindow(options, options.samples) && !createWindow(options, 0))
        return failed("SDL_CreateWindow");
    m_context = m_sdl.GL_CreateContext(m_window);
    if (m_context == nullptr)
        return failed("SDL_GL_CreateContext");
    m_sdl.GL_SetSwapInterval(0); // The timer paces it; a swap must not wait.
    m_sdl.GL_GetAttribute(SDL_GL_MULTISAMPLESAMPLES, &m_samples);
    SDL_DisplayMode mode = {};
    if (m_sdl.GetCurrentDisplayMode(m_sdl.GetWindowDisplayIndex(m_window), &mode) == 0)
        m_refreshMilliHertz = mode.refresh_rate * 1000;
    arm(m_timer, monotonicNow() + kPoll);
    return makeReady();
}

Result<void> SdlWindow::bind() {
    if (m_sdl.GL_MakeCurrent(m_window, m_context) != 0)
        return failed("SDL_GL_MakeCurrent");
    return {};
}

Result<void> SdlWindow::finishFrame() {
    m_sdl.GL_SwapWindow(m_window);
    m_wantsFrame = false;
    m_state = SurfaceState::Busy;
    return {};
}

SurfaceEvents SdlWindow::dispatch() {
    SurfaceEvents events;
    for (SDL_Event event; m_sdl.PollEvent(&event) != 0;)
        if (event.type == SDL_QUIT)
            events.closeRequested = true;
        else if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_EXPOSED)
            m_wantsFrame = true;
    Size size;
    m_sdl.GL_GetDrawableSize(m_window, &size.width, &size.height);
    events.layoutChanged = size != std::exchange(m_size, size);
    if (m_state == SurfaceState::Busy) {
        m_state = SurfaceState::Ready;
        events.stateChanged = true;
        events.completed = CompletedFrame{++m_frames, monotonicNow().count(), 0};
    }
    drain(m_timer);
    arm(m_timer, monotonicNow() + kPoll);
    return events;
}

} // namespace

Result<std::unique_ptr<Surface>> createWindow(const SurfaceOptions& options) {
    const Result<Sdl> sdl = Sdl::open();
    if (!sdl)
        return sdl.error();
    auto surface = std::make_unique<SdlWindow>(*sdl, options.size);
    if (Result<void> opened = surface->open(options); !opened)
        return opened.error();
    return std::unique_ptr<Surface>(std::move(surface));
}

} // namespace franken::platform

#else

namespace franken::platform {

Result<std::unique_ptr<Surface>> createWindow(const SurfaceOptions&) {
    return Error{"surface.not-installed", "window", "the library was built without SDL2",
                 "build it where libsdl2-dev is installed, or choose another backend"};
}

} // namespace franken::platform

#endif
