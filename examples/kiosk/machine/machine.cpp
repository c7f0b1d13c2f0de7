// SPDX-License-Identifier: MIT
#include "kiosk/machine/machine.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace kiosk {

namespace fs = std::filesystem;

namespace {

// Files of /sys and /proc have no size, so that readFile() of lib/base refuses them.
constexpr std::size_t kMostBytes = std::size_t{64} << 10;

constexpr const char* kThrottled = "/sys/devices/platform/soc/soc:firmware/get_throttled";
constexpr double kDefaultMebibytes = 512;

std::optional<double> numberOf(const std::optional<std::string>& text, int base) {
    if (!text)
        return {};
    char* end = nullptr;
    const double value = base == 16 ? static_cast<double>(std::strtoul(text->c_str(), &end, 16))
                                    : std::strtod(text->c_str(), &end);
    return end == text->c_str() ? std::nullopt : std::optional(value);
}

} // namespace

std::optional<std::string> Machine::text(const std::string& file) const {
    std::ifstream stream(path(file), std::ios::binary);
    if (!stream)
        return {};
    std::string text(kMostBytes, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return text;
}

std::optional<std::string> Machine::line(const std::string& file) const {
    std::optional<std::string> all = text(file);
    if (all)
        all->resize(std::min(all->size(), all->find_first_of(std::string("\n\0", 2))));
    return all;
}

std::vector<std::string> Machine::names(const std::string& folder) const {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator each(path(folder), error), end; !error && each != end; each.increment(error))
        names.push_back(each->path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string Machine::model() const { return line("/proc/device-tree/model").value_or(""); }

std::optional<double> Machine::celsius() const {
    std::optional<double> hottest;
    for (const std::string& zone : names("/sys/class/thermal"))
        if (zone.starts_with("thermal_zone"))
            if (const auto milli = numberOf(line("/sys/class/thermal/" + zone + "/temp"), 10))
                hottest = std::max(hottest.value_or(-273), *milli / 1000);
    return hottest;
}

std::optional<unsigned> Machine::throttled() const {
    const std::optional<double> bits = numberOf(line(kThrottled), 16);
    return bits ? std::optional(static_cast<unsigned>(*bits)) : std::nullopt;
}

std::optional<double> Machine::memoryMebibytes(const std::string& name) const {
    std::istringstream lines(text("/proc/meminfo").value_or(""));
    for (std::string each; std::getline(lines, each);)
        if (each.starts_with(name + ":"))
            if (const auto kibibytes = numberOf(each.substr(name.size() + 1), 10))
                return *kibibytes / 1024;
    return {};
}

std::optional<double> residentMebibytes() {
    std::istringstream lines(Machine().text("/proc/self/status").value_or(""));
    for (std::string each; std::getline(lines, each);)
        if (each.starts_with("VmRSS:"))
            if (const auto kibibytes = numberOf(each.substr(6), 10))
                return *kibibytes / 1024;
    return {};
}

Strain Machine::strain() const {
    // Bits 0-3: under-voltage, frequency capped, throttled, soft temperature limit; now, not since the start.
    constexpr unsigned kCappedOrThrottledNow = 0b1110;
    const std::optional<unsigned> bits = throttled();
    return {.celsius = celsius(),
            .throttled = bits ? std::optional((*bits & kCappedOrThrottledNow) != 0) : std::nullopt,
            .freeMebibytes =
                memoryMebibytes("CmaTotal").value_or(0) > 0 ? memoryMebibytes("CmaFree") : std::nullopt};
}

std::size_t memoryBudget(int mebibytes, const Machine& machine) {
    const double contiguous = machine.memoryMebibytes("CmaTotal").value_or(0);
    const double budget = mebibytes > 0 ? mebibytes : contiguous > 0 ? contiguous / 2 : kDefaultMebibytes;
    return static_cast<std::size_t>(budget * (1 << 20));
}

} // namespace kiosk
