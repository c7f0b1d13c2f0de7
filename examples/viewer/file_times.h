// SPDX-License-Identifier: MIT
#pragma once

#include "options.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

/// When files were last written, and their sizes in bytes. Equal where nothing has changed.
using FileTimes = std::map<std::filesystem::path, std::pair<std::filesystem::file_time_type, std::uintmax_t>>;

/// Of the sky's file, or of the pictures in its folder; nothing without a sky.
FileTimes skyTimes(const Options& options);

/// Of all that a picture is made of: the model, the files in its folder and the folders therein that may
/// belong to it, the height map, the sky and the snippets.
FileTimes inputTimes(const Options& options);
