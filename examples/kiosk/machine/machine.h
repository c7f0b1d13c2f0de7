// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/decide/relief.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kiosk {

/// What files of /sys and /proc say. Tests give another root.
class Machine {
public:
    explicit Machine(std::filesystem::path root = "/") : m_root(std::move(root)) {}

    /// "Raspberry Pi 4 Model B Rev 1.4"; empty on other machines.
    std::string model() const;
    std::optional<double> celsius() const;
    /// Bits of the firmware's get_throttled; nothing where there is no such file.
    std::optional<unsigned> throttled() const;
    /// A line of /proc/meminfo: "CmaTotal", "MemAvailable".
    std::optional<double> memoryMebibytes(const std::string& name) const;
    Strain strain() const;

    /// The first line of a file below the root, without its end; nothing where it cannot be read.
    std::optional<std::string> line(const std::string& path) const;
    std::optional<std::string> text(const std::string& path) const;
    /// The names in a folder, sorted.
    std::vector<std::string> names(const std::string& folder) const;
    std::filesystem::path path(const std::string& absolute) const { return m_root / absolute.substr(1); }

private:
    std::filesystem::path m_root;
};

/// Of this process, whatever the root.
std::optional<double> residentMebibytes();

/// GPU memory for models in bytes: as configured (MiB), or half of the contiguous memory, or 512 MiB.
std::size_t memoryBudget(int mebibytes, const Machine& machine);

} // namespace kiosk
