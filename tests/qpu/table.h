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

/// These throw std::runtime_error where the file cannot be written.
void writeTable(const std::filesystem::path& file, const Table& table);

void writeText(const std::filesystem::path& file, const std::string& text);

std::string readText(const std::filesystem::path& file);

} // namespace franken::test
