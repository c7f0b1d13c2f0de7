// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace franken::test {

/// A file of tab-separated columns; its first row names them.
using Row = std::vector<std::string>;
using Table = std::vector<Row>;

/// An empty table where the file cannot be read.
Table readTable(const std::filesystem::path& file);

void writeTable(const std::filesystem::path& file, const Table& table);

std::string readText(const std::filesystem::path& file);

} // namespace franken::test
