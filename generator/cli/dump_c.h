// SPDX-License-Identifier: MIT
#pragma once

#include "program.h"

#include <string>

namespace franken::cli {

/// The programs as one header of C99 and C++: their texts as string literals, their interfaces as tables, and
/// a table of all of them. A piece at a time: begin(), program() for each, end(). Names that are no
/// identifiers of C become some: basecolor_normal_sun1.
class DumpC {
public:
    std::string begin() const;
    std::string program(const Program& program);
    std::string end() const;

private:
    std::string m_table; ///< The rows of the last table.
    std::size_t m_count = 0;
};

} // namespace franken::cli
