// SPDX-License-Identifier: MIT
#pragma once

#include "finding.h"
#include "franken/result.h"
#include "program.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace franken::cli {

/// The Khronos reference compiler as a program beside ours, fed through files in a temporary directory that
/// goes with this object.
class Glslang {
public:
    /// Nothing where glslangValidator is not installed. Fails with "glslang.run" where it cannot be run or
    /// no temporary file can be written.
    static Result<std::optional<Glslang>> open();

    Glslang(Glslang&& other) noexcept;
    Glslang& operator=(Glslang&&) = delete;
    ~Glslang();

    /// What it has to say against the program, each line with the snippet it comes from.
    Result<std::vector<Finding>> check(const Program& program) const;

private:
    explicit Glslang(std::filesystem::path directory);

    std::filesystem::path m_directory;
};

} // namespace franken::cli
