// SPDX-License-Identifier: MIT
#include "backends.h"

namespace franken::platform {

namespace {

// Drivers share the thread's dispatch table (Mesa's libglapi) without knowing of each other: EGL would take a
// context for current that OSMesa has replaced. So each is told to let go before the next one binds.
thread_local Surface* currentSurface = nullptr;

struct BackendRow {
    Backend backend;
    std::string_view text;
    Result<std::unique_ptr<Surface>> (*create)(const SurfaceOptions&);
};

constexpr BackendRow kBackends[] = {
    {Backend::OsMesa, "osmesa", createOsMesa},
    {Backend::EglSurfaceless, "egl", createEglSurfaceless},
};

const BackendRow& rowOf(Backend backend) {
    for (const BackendRow& row : kBackends)
        if (row.backend == backend)
            return row;
    assert(false);
    return kBackends[0];
}

Result<void> check(const SurfaceOptions& options) {
    const auto inRange = [](int extent) { return extent >= 1 && extent <= kMaxSurfaceSize; };
    const auto [width, height] = options.size;
    if (!inRange(width) || !inRange(height))
        return Error{"surface.options", std::to_string(width) + "x" + std::to_string(height),
                     "a surface of that size cannot be made",
                     "choose a width and height of 1 to " + std::to_string(kMaxSurfaceSize) + " pixels"};
    if (options.depthBits < 0 || options.depthBits > 32)
        return Error{"surface.options", std::to_string(options.depthBits) + " bits",
                     "a depth buffer of that depth cannot be made", "choose 0 to 32 bits"};
    return {};
}

} // namespace

Result<void> Surface::makeCurrent() {
    if (currentSurface != nullptr && currentSurface != this)
        currentSurface->unbind();
    currentSurface = nullptr;
    if (Result<void> bound = bind(); !bound)
        return bound;
    currentSurface = this;
    return {};
}

Surface::Detached::Detached(const Surface& dying) : m_previous(currentSurface) {
    if (m_previous != nullptr)
        m_previous->unbind();
    currentSurface = nullptr;
    if (m_previous == &dying)
        m_previous = nullptr;
}

Surface::Detached::~Detached() {
    if (m_previous != nullptr && m_previous->bind())
        currentSurface = m_previous;
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
    constexpr unsigned kRenderer =
        0x1F01; // GL_RENDERER and GL_VERSION: no GL header here, two drivers differ
    constexpr unsigned kVersion = 0x1F02;
    m_driver = text(kRenderer) + ", " + text(kVersion);
    return {};
}

std::string_view toString(Backend backend) { return rowOf(backend).text; }

Result<Backend> parseBackend(std::string_view text) {
    std::string choices;
    for (const BackendRow& row : kBackends) {
        if (row.text == text)
            return row.backend;
        choices.append(choices.empty() ? "" : ", ").append(row.text);
    }
    return Error{"surface.backend", std::string(text), "there is no such backend",
                 "choose one of " + choices};
}

Result<std::unique_ptr<Surface>> create(Backend backend, const SurfaceOptions& options) {
    if (Result<void> valid = check(options); !valid)
        return valid.error();
    Result<std::unique_ptr<Surface>> surface = rowOf(backend).create(options);
    if (surface && options.log)
        options.log(LogLevel::Info, std::string(toString(backend)) + ": " + (*surface)->driver());
    return surface;
}

} // namespace franken::platform
