// SPDX-License-Identifier: MIT
#include "backends.h"

#include <cstdlib>
#include <iterator>

namespace franken::platform {

namespace {

// Drivers share the thread's dispatch table (Mesa's libglapi) without knowing of each other: EGL would take a
// context for current that OSMesa has replaced. So each is told to let go before the next one binds.
thread_local Surface* currentSurface = nullptr;

struct BackendRow {
    std::string_view text;
    Result<std::unique_ptr<Surface>> (*create)(const SurfaceOptions&);
};

/// In the order of the enumeration.
constexpr BackendRow kBackends[] = {
    {"osmesa", createOsMesa}, {"egl", createEglSurfaceless}, {"kms", createKms}, {"window", createWindow}};

/// In the order of the enumeration.
constexpr std::string_view kStates[] = {"ready",   "busy",       "no screen", "paused",
                                        "blanked", "recovering", "failed"};

const BackendRow& rowOf(Backend backend) { return kBackends[static_cast<std::size_t>(backend)]; }

Result<void> check(const SurfaceOptions& options) {
    const auto inRange = [](int extent) { return extent >= 1 && extent <= kMaxSurfaceSize; };
    const auto [width, height] = options.size;
    if (!inRange(width) || !inRange(height))
        return Error{"surface.options", std::to_string(width) + "x" + std::to_string(height),
                     "the size of the surface is out of range",
                     "choose a width and height of 1 to " + std::to_string(kMaxSurfaceSize) + " pixels"};
    if (options.depthBits < 0 || options.depthBits > 32)
        return Error{"surface.options", std::to_string(options.depthBits) + " bits",
                     "the depth of the depth buffer is out of range", "choose 0 to 32 bits"};
    if (options.samples < 0 || options.samples > kMaxSamples)
        return Error{"surface.options", std::to_string(options.samples) + " samples",
                     "the number of samples is out of range",
                     "choose 0 to " + std::to_string(kMaxSamples) + " samples"};
    const ScreenOptions& screen = options.screen;
    if (!screen.mirror.empty() && screen.mirror == screen.output)
        return Error{"surface.options", screen.mirror, "an output cannot mirror itself",
                     "name two different outputs"};
    return {};
}

} // namespace

Result<void> Surface::makeCurrent() {
    if (currentSurface != nullptr && currentSurface != this)
        currentSurface->letGo();
    if (Result<void> bound = bind(); !bound)
        return bound;
    currentSurface = this;
    return {};
}

void Surface::letGo() {
    if (currentSurface != this)
        return;
    unbind();
    currentSurface = nullptr;
}

Result<bool> Surface::begin() {
    if (m_state != SurfaceState::Ready)
        return false;
    if (Result<void> current = makeCurrent(); !current)
        return current.error();
    frameBegun();
    m_begun = true;
    return true;
}

Result<void> Surface::submit() {
    if (!m_begun)
        return Error{"surface.state", "submit", "no frame was begun",
                     "draw and submit only where begin() returned true"};
    m_begun = false;
    return finishFrame();
}

Result<void> Surface::blank(Blanking) {
    return Error{"surface.unsupported", std::string(toString(m_backend)),
                 "this surface has no screen to make dark", "use the backend kms"};
}

Result<void> Surface::makeReady() {
    if (Result<void> current = makeCurrent(); !current)
        return current;
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(getProcAddress()("glGetString"));
    const auto text = [&](unsigned name) {
        const unsigned char* string = getString == nullptr ? nullptr : getString(name);
        return std::string(string == nullptr ? "unknown" : reinterpret_cast<const char*>(string));
    };
    constexpr unsigned kRenderer = 0x1F01; // As in any GL header; OSMesa's and GLES2's cannot be mixed.
    constexpr unsigned kVersion = 0x1F02;
    m_driver = text(kRenderer) + ", " + text(kVersion);
    return {};
}

std::string_view toString(Backend backend) { return rowOf(backend).text; }

std::string_view toString(SurfaceState state) { return kStates[static_cast<std::size_t>(state)]; }

Result<Backend> parseBackend(std::string_view text) {
    std::string choices;
    for (std::size_t i = 0; i < std::size(kBackends); ++i) {
        if (kBackends[i].text == text)
            return static_cast<Backend>(i);
        choices.append(choices.empty() ? "" : ", ").append(kBackends[i].text);
    }
    return Error{"surface.backend", std::string(text), "there is no such backend",
                 "choose one of " + choices};
}

Result<std::unique_ptr<Surface>> create(Backend backend, const SurfaceOptions& options) {
    if (Result<void> valid = check(options); !valid)
        return valid.error();
    constexpr int kKeep = 0;
    if (!options.shaderCache.empty())
        setenv("MESA_SHADER_CACHE_DIR", options.shaderCache.c_str(), kKeep);
    Result<std::unique_ptr<Surface>> surface = rowOf(backend).create(options);
    if (surface && options.log)
        options.log(LogLevel::Info, std::string(toString(backend)) + ": " + (*surface)->driver());
    return surface;
}

} // namespace franken::platform
