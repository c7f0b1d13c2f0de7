// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/surface.h"
#include "kiosk/decide/frame_times.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kiosk {

/// What a kiosk says of itself, on the screen and to node_exporter.
struct Statistics {
    FrameTimes frames;
    std::string state; ///< "drawing", "blanked", ...
    std::uint64_t modelsShown = 0;
    std::size_t models = 0, modelsBroken = 0;
    std::uint64_t programs = 0, compiles = 0; ///< Linked, and shaders compiled, since the start.
    std::size_t fallbacks = 0;
    double gpuBytes = 0, gpuBudgetBytes = 0;
    std::optional<double> residentBytes, freeContiguousBytes, celsius;
    std::optional<unsigned> throttled; ///< The firmware's bits.
    int reliefStep = 0;
    double startSeconds = 0; ///< Since the epoch.
};

/// "drawing" of a screen that is ready or busy; as the surface calls it otherwise.
std::string stateName(franken::platform::SurfaceState state);

/// Prometheus' text format, by the conventions of its names: base units, _total for counters.
std::string toPrometheus(const Statistics& statistics);

/// For the screen: one line each.
std::vector<std::string> toLines(const Statistics& statistics);

} // namespace kiosk
