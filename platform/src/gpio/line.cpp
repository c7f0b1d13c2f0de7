// SPDX-License-Identifier: MIT
#include "line.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace franken::platform {

namespace {

/// The chips of the 40-pin header: Pi 0–3, Pi 4, Pi 5.
constexpr std::string_view kHeaderChips[] = {"pinctrl-bcm2835", "pinctrl-bcm2711", "pinctrl-rp1"};

std::vector<std::string> chipPaths() {
    std::vector<std::string> paths;
    std::error_code error;
    for (std::filesystem::directory_iterator at("/dev", error), end; !error && at != end; at.increment(error))
        if (at->path().filename().string().starts_with("gpiochip"))
            paths.push_back(at->path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

bool isMeant(const GpioChip& chip, const std::string& name) {
    if (name.empty())
        return std::find(std::begin(kHeaderChips), std::end(kHeaderChips), chip.label) !=
               std::end(kHeaderChips);
    return name == chip.label || name == chip.name || name == chip.path;
}

std::string describe(const GpioPin& pin) {
    return "GPIO " + std::to_string(pin.number) + (pin.chip.empty() ? "" : " of " + pin.chip);
}

} // namespace

Result<GpioChip> findChip(const GpioPin& pin) {
    for (const std::string& path : chipPaths())
        if (std::optional<GpioChip> chip = describeChip(path); chip && isMeant(*chip, pin.chip)) {
            if (pin.number < chip->lines)
                return *std::move(chip);
            return Error{"gpio.missing", describe(pin),
                         "the chip has " + std::to_string(chip->lines) + " lines, counted from 0",
                         "correct the pin's number"};
        }
    return Error{
        "gpio.missing", describe(pin),
        pin.chip.empty() ? "the chip of a Raspberry Pi's header was not found" : "there is no such chip",
        "list chips and lines with gpioinfo and give the chip's label, or put the user into the group gpio"};
}

Result<std::unique_ptr<GpioLine>> openLine(const GpioPin& pin, GpioSettings settings) {
    const Result<GpioChip> chip = findChip(pin);
    if (!chip)
        return chip.error();
    settings.chip = chip->path;
    settings.number = pin.number;
    std::unique_ptr<GpioLine> line = requestLine(settings);
    if (line)
        return line;
    if (errno == EBUSY)
        return Error{"gpio.busy", describe(pin), "another program or a driver holds the line",
                     "find its name with gpioinfo; end it, or remove the overlay from config.txt"};
    return Error{"gpio.driver", describe(pin), std::strerror(errno), "check that the chip supports the pull"};
}

} // namespace franken::platform
