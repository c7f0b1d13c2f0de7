// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace franken::test {

/// A chip with the label of a Pi 4's header, as long as it lives: by the kernel's gpio-sim.
class SimChip {
public:
    SimChip();
    ~SimChip();
    SimChip(const SimChip&) = delete;
    SimChip& operator=(const SimChip&) = delete;

    void pull(unsigned line, bool up) const;
    std::string value(unsigned line) const; ///< Of an output: "0" or "1".

private:
    std::string file(unsigned line, const char* name) const;
    std::string m_lines;
};

} // namespace franken::test
