// SPDX-License-Identifier: MIT
// soak osmesa|egl [SECONDS]: a kiosk's life at 15 frames a second, two hours unless told otherwise. Models
// are swapped, evicted and read from their file again, skies come and go, and the context is lost every half
// minute. A line a minute says the most that the process held in it, and the end says whether that grows: of
// what is allocated, by anyone and by C++ alone. The pages that the allocator keeps depend on what was freed
// last: RSS is printed, not judged. Exit code 1: memory or descriptors grow.
#include "memory_use.h"
#include "support/draw_scene.h"
#include "support/shapes.h"

#include "franken/gltf.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <thread>

namespace franken::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFramesASecond = 15;
constexpr int kSwapFrames = 48, kSkyFrames = 110, kLossFrames = 410; // No two have a common period.
constexpr platform::Size kSize{96, 96};
constexpr double kMostGrowth = 256 * 1024; // Bytes in two hours.
constexpr double kTwoHours = 7200;
constexpr std::size_t kRoom = 512 * 1024; // For one of the two small models beside the large one.

Result<Scene> urn() { return loadGltf(URN_GLB); }

Result<Scene> ball(const glm::vec4& color) {
    SceneBuilder builder;
    Material material;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(256, 8, color, glm::vec4(1)));
    builder.add(sphere(24), builder.addMaterial(material));
    return builder.scene;
}

struct Counts {
    int frames = 0, swaps = 0, losses = 0;
};

[[noreturn]] void fail(const char* what, const Error& error) {
    std::fprintf(stderr, "soak: %s: %s\n", what, toString(error).c_str());
    std::exit(error.code == "surface.not-installed" ? 77 : 1);
}

template<typename T>
T require(const char* what, Result<T> result) {
    if (!result)
        fail(what, result.error());
    return *std::move(result);
}

void require(const char* what, const Result<void>& result) {
    if (!result)
        fail(what, result.error());
}

/// A renderer with three models, one of which is shown.
class Show {
public:
    explicit Show(platform::Backend backend)
        : m_backend(backend),
          m_offscreen(require("context", openOffscreen(backend, kSize))),
          m_renderer(m_offscreen.gl) {
        for (const SceneSource& source : m_sources) {
            const Scene scene = require("model", source());
            m_models.push_back(require("add", m_renderer.add(scene, source)));
            m_cameras.push_back(framingCamera(scene.bounds(), 1));
            if (m_models.size() == 1)
                m_renderer.memory().setBudget(m_renderer.memory().used() + kRoom);
        }
        m_sky.images.fill({"", 1, 1, {255, 255, 255, 64}});
    }

    void frame(Counts& counts) {
        const int number = counts.frames++;
        if (number % kSwapFrames == 0) {
            m_shown = static_cast<std::size_t>(counts.swaps++) % m_models.size();
            require("show", m_renderer.show({{m_models[m_shown]}}, Wait::Yes));
        }
        if (number % kSkyFrames == 0)
            changeSky(number / kSkyFrames % 2 == 0);
        if (number % kLossFrames == kLossFrames - 1) {
            loseContext();
            ++counts.losses;
        }
        const DrawTarget target{
            .framebuffer = m_offscreen.surface->framebuffer(), .width = kSize.width, .height = kSize.height};
        require("draw", m_renderer.draw(viewpointOf(m_cameras[m_shown], 1), target));
        m_offscreen.gl.Finish();
    }

private:
    void changeSky(bool visible) {
        Lighting lighting;
        lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
        lighting.ambient.kind = visible ? Ambient::Sky : Ambient::Color;
        lighting.ambient.sky[0] = {1, 1, 1};
        m_renderer.setLighting(lighting);
        require("sky", m_renderer.setSkybox(visible ? &m_sky : nullptr,
                                            [this] { return Result<SkyboxMap>(m_sky); }));
    }

    void loseContext() {
        m_renderer.contextLost();
        m_offscreen = {};
        m_offscreen = require("new context", openOffscreen(m_backend, kSize));
        require("restore", m_renderer.restore(m_offscreen.gl));
    }

    platform::Backend m_backend;
    Offscreen m_offscreen;
    Renderer m_renderer;
    std::vector<SceneSource> m_sources{urn,
                                       [] {
                                           return ball({1, 0, 0, 1});
                                       },
                                       [] {
                                           return ball({0, 0, 1, 1});
                                       }};
    std::vector<ModelId> m_models;
    std::vector<Camera> m_cameras;
    SkyboxMap m_sky{.size = 1, .range = 64, .images = {}};
    std::size_t m_shown = 0;
};

void print(const MemoryUse& use, const Counts& counts) {
    std::printf(
        "%6.0f s  %7d frames  %5d swaps  %4d losses  RSS %7zu KiB  heap %7zu KiB  C++ %7zu KiB  %3zu files\n",
        use.seconds, counts.frames, counts.swaps, counts.losses, use.resident / 1024, use.heap / 1024,
        use.cpp / 1024, use.descriptors);
    std::fflush(stdout);
}

/// The most of each member.
MemoryUse most(const MemoryUse& a, const MemoryUse& b) {
    return {.seconds = std::max(a.seconds, b.seconds),
            .resident = std::max(a.resident, b.resident),
            .heap = std::max(a.heap, b.heap),
            .cpp = std::max(a.cpp, b.cpp),
            .descriptors = std::max(a.descriptors, b.descriptors)};
}

/// Whether nothing grew after the first sixth, in which caches fill.
bool flat(std::vector<MemoryUse> samples) {
    samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 6));
    bool ok = samples.front().descriptors == samples.back().descriptors;
    const std::pair<const char*, std::size_t MemoryUse::*> kinds[] = {{"heap", &MemoryUse::heap},
                                                                      {"C++", &MemoryUse::cpp}};
    for (const auto& [name, member] : kinds) {
        const double growth = slope(samples, member) * kTwoHours;
        std::printf("%s: %+.0f KiB in two hours\n", name, growth / 1024);
        ok = ok && std::abs(growth) <= kMostGrowth;
    }
    const auto [least, largest] = std::ranges::minmax(samples, {}, &MemoryUse::resident);
    std::printf("RSS: %zu to %zu KiB, %+.0f KiB in two hours\n", least.resident / 1024,
                largest.resident / 1024, slope(samples, &MemoryUse::resident) * kTwoHours / 1024);
    return ok;
}

bool soak(platform::Backend backend, double seconds) {
    const auto begin = Clock::now();
    const auto elapsed = [begin] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    Show show(backend);
    Counts counts;
    std::vector<MemoryUse> samples;
    MemoryUse held;
    const double interval = std::min(60.0, seconds / 10);
    for (auto next = begin; elapsed() < seconds; std::this_thread::sleep_until(next)) {
        next += std::chrono::milliseconds(1000 / kFramesASecond);
        show.frame(counts);
        held = most(held, memoryUse(elapsed()));
        if (elapsed() < interval * static_cast<double>(samples.size() + 1))
            continue;
        samples.push_back(held);
        print(held, counts);
        held = {};
    }
    // A short run shows that the program works, not that memory is flat.
    constexpr double kTellingSeconds = 1200;
    return flat(samples) || seconds < kTellingSeconds;
}

} // namespace
} // namespace franken::test

int main(int argc, char** argv) {
    using namespace franken;
    const std::string_view name = argc > 1 ? argv[1] : "";
    for (const platform::Backend backend : {platform::Backend::OsMesa, platform::Backend::EglSurfaceless})
        if (name == platform::toString(backend))
            return test::soak(backend, argc > 2 ? std::atof(argv[2]) : test::kTwoHours) ? 0 : 1;
    std::fprintf(stderr, "usage: soak osmesa|egl [SECONDS]\n");
    return 2;
}
