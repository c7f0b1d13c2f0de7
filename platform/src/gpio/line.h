// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/gpio.h"

#include <optional>

namespace franken::platform {

struct GpioSettings {
    std::string chip = {}; ///< Path.
    unsigned number = 0;
    bool activeLow = false;
    Pull pull = Pull::AsIs;
    std::optional<bool> output = {}; ///< The level at first; an input without.
};

/// A line that is ours. Calls return a negative errno where they fail.
class GpioLine {
public:
    virtual ~GpioLine() = default;
    virtual int descriptor() const = 0; ///< Of an input: readable when there are edges.
    virtual int value() = 0;            ///< 0 or 1.
    virtual int set(bool active) = 0;
    /// Edges that are there; waits for none.
    virtual int readEdges(std::vector<ContactEdge>& edges) = 0;
};

struct GpioChip {
    std::string path, name, label;
    unsigned lines = 0;
};

// By libgpiod; there is one file of them for each of its two interfaces.
std::optional<GpioChip> describeChip(const std::string& path);
/// Null and errno where it fails.
std::unique_ptr<GpioLine> requestLine(const GpioSettings& settings);

/// The chip that a pin is on. Fails with `gpio.missing`.
Result<GpioChip> findChip(const GpioPin& pin);

/// Finds the chip and takes the line. Fails with `gpio.missing`, `gpio.busy` or `gpio.driver`.
Result<std::unique_ptr<GpioLine>> openLine(const GpioPin& pin, GpioSettings settings);

} // namespace franken::platform
