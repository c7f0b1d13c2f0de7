// SPDX-License-Identifier: MIT
#include "measure.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

using namespace franken;

namespace {

constexpr int kWarmUpFrames = 30, kTimedFrames = 60;

} // namespace

bool isSoftware(std::string_view renderer) {
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "swrast"})
        if (renderer.find(name) != std::string_view::npos)
            return true;
    return false;
}

Result<Measured> timeFrames(const Gl& gl, const std::function<Result<void>()>& draw) {
    using Clock = std::chrono::steady_clock;
    const auto* const name = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    Measured measured{.renderer = name == nullptr ? "" : name};
    if (isSoftware(measured.renderer))
        return Error{
            "viewer.measure", measured.renderer,
            "this is software: how long it takes says nothing of a Raspberry Pi's GPU, neither of its "
            "instructions nor of its memory",
            "run it on the Raspberry Pi, as a user of the groups video and render"};
    std::vector<double> times;
    for (int frame = 0; frame < kWarmUpFrames + kTimedFrames; ++frame) {
        const Clock::time_point begin = Clock::now();
        if (Result<void> drawn = draw(); !drawn)
            return drawn.error();
        gl.Finish();
        const std::chrono::duration<double, std::milli> taken = Clock::now() - begin;
        if (frame >= kWarmUpFrames)
            times.push_back(taken.count());
    }
    std::sort(times.begin(), times.end());
    measured.frames = kTimedFrames;
    measured.least = times.front();
    measured.milliseconds = times[times.size() / 2];
    return measured;
}

std::string comparisonOf(const Measured& measured, const price::FrameBill& predicted) {
    char text[320];
    std::snprintf(
        text, sizeof text,
        "\nmeasured on %.100s: %.2f ms (median of %d frames; the fastest %.2f)\n"
        "predicted for a %s: %.2f to %.2f ms; measured is %.2f times the least, the processor's share "
        "included\n",
        measured.renderer.c_str(), measured.milliseconds, measured.frames, measured.least,
        std::string(predicted.machine.model.name).c_str(), predicted.least(), predicted.most(),
        measured.milliseconds / predicted.least());
    return text;
}
