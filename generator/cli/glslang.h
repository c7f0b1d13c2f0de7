// SPDX-License-Identifier: MIT
#pragma once

#include "finding.h"
#include "franken/result.h"
#include "program.h"
#include "temporary_folder.h"

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

    /// What it has to say against the program, each line with the snippet it comes from.
    Result<std::vector<Finding>> check(const Program& program) const;

private:
    explicit Glslang(TemporaryFolder folder) : m_folder(std::move(folder)) {}

    TemporaryFolder m_folder;
};

} // namespace franken::cli
