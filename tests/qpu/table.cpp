// SPDX-License-Identifier: MIT
#include "table.h"

#include <fstream>
#include <sstream>

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
    std::ofstream out(file, std::ios::binary);
    for (const Row& row : table)
        for (std::size_t i = 0; i < row.size(); ++i)
            out << row[i] << (i + 1 < row.size() ? '\t' : '\n');
}

std::string readText(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

} // namespace franken::test
