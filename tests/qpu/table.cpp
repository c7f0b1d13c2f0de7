// SPDX-License-Identifier: MIT
#include "table.h"

#include "franken/file_writer.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace franken::test {

Table readTable(const std::filesystem::path& file) {
    Table table;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        Row& row = table.emplace_back();
        std::istringstream columns(line);
        for (std::string column; std::getline(columns, column, '\t');)
            row.push_back(column);
    }
    return table;
}

void writeTable(const std::filesystem::path& file, const Table& table) {
    std::ostringstream out;
    for (const Row& row : table)
        for (std::size_t i = 0; i < row.size(); ++i)
            out << row[i] << (i + 1 < row.size() ? '\t' : '\n');
    writeText(file, out.str());
}

void writeText(const std::filesystem::path& file, const std::string& text) {
    if (const Result<void> written = writeFile(file, text); !written)
        throw std::runtime_error(toString(written.error()));
}

std::string readText(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace franken::test
