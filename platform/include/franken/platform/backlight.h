// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <string>

namespace franken {
namespace FRANKEN_API platform {

/// A panel's backlight, through the kernel's backlight class (DSI and DPI panels have one; HDMI screens do
/// not).
class Backlight {
public:
    /// The first one by name, or the named one. Fails with `backlight.missing`.
    static Result<Backlight> find(const std::string& name = {},
                                  const std::string& folder = "/sys/class/backlight");

    /// The kernel's name of the device.
    const std::string& name() const { return m_name; }
    /// 0 is off or darkest, 1 brightest. Fails with `backlight.range` outside 0-1, and with `backlight.write`
    /// (without write permission; a udev rule can give it to the group video).
    Result<void> setBrightness(double brightness);
    Result<double> brightness() const;

private:
    Backlight(std::string name, std::string folder, int most)
        : m_name(std::move(name)), m_folder(std::move(folder)), m_most(most) {}
    std::string m_name, m_folder;
    int m_most;
};

} // namespace platform
} // namespace franken
