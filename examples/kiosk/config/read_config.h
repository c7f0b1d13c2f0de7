// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "kiosk/config/config.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace kiosk {

/// What options on the command line say, by key; they win over the file.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// A configuration, and everything that is wrong with it: what is wrong keeps its default. An error's `where`
/// is "file:line:column", or the option.
struct ReadConfig {
    Config config;
    std::vector<franken::Error> faults;
};

/// `name` is for messages. Paths are relative to `folder`.
ReadConfig parseConfig(const std::string& text, const std::string& name, const std::filesystem::path& folder);

/// Without a file (an empty path), the defaults with the overrides, whose paths are relative to where the
/// program runs.
ReadConfig readConfig(const std::filesystem::path& file, const Overrides& overrides = {});

/// The keys of settings that differ and take effect only after a restart.
std::vector<std::string> needRestart(const Config& before, const Config& after);

} // namespace kiosk
