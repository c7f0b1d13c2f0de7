// SPDX-License-Identifier: MIT
#include "gpu.h"

#include <cassert>

namespace franken::cli {
namespace {

constexpr PiModel kVc4Models[] = {
    {"Pi 1, Pi 2", 250, "pi2", 3200}, {"Pi 0, Pi Zero 2", 300, "pi0", 3600}, {"Pi 3", 300, "pi3", 3600}};
constexpr PiModel kV3d42Models[] = {{"Pi 4", 500, "pi4", 12'800}};
constexpr PiModel kV3d71Models[] = {{"Pi 5", 960, "pi5", 17'068}};

constexpr Gpu kGpus[] = {{"vc4", "VideoCore IV: Raspberry Pi 0 to 3", Target::Vc4, 12, 6, kVc4Models},
                         {"v3d42", "VideoCore VI: Raspberry Pi 4", Target::Generic, 8, 0, kV3d42Models},
                         {"v3d71", "VideoCore VII: Raspberry Pi 5", Target::Generic, 16, 0, kV3d71Models}};

constexpr int kLanes = 4;

} // namespace

std::span<const Gpu> gpus() { return kGpus; }

Result<Gpu> findGpu(std::string_view name) {
    for (const Gpu& gpu : kGpus)
        if (gpu.name == name)
            return gpu;
    return Error{"cost.unknown-gpu", std::string(name), "there is no such GPU", "use vc4, v3d42 or v3d71"};
}

Permutation forGpu(const Permutation& permutation, const Gpu& gpu) {
    Permutation targeted = permutation;
    if (targeted.target == Target::Generic)
        targeted.target = gpu.target;
    const auto canonical = canonicalise(targeted);
    assert(canonical);
    return canonical->permutation;
}

double megapixelsPerSecond(const Gpu& gpu, const PiModel& model, int instructions) {
    assert(instructions > 0);
    return static_cast<double>(gpu.qpus) * kLanes * model.megahertz / instructions;
}

} // namespace franken::cli
