// SPDX-License-Identifier: MIT
#pragma once

#include "finding.h"
#include "franken/result.h"
#include "program.h"
#include "temporary_folder.h"

#include <optional>
#include <span>
#include <vector>

namespace franken::cli {

/// The Khronos reference compiler as a program beside ours, fed through files in a temporary directory that
/// goes with this object.
class Glslang {
public:
    /// Nothing where glslangValidator is not installed. Fails with "glslang.run" where it cannot be run or
    /// no temporary file can be written.
    static Result<std::optional<Glslang>> open();

    /// What it has to say against each of the programs, each line with the snippet it comes from. All are
    /// given to one process; where it does not survive them, each gets one of its own.
    Result<std::vector<std::vector<Finding>>> check(std::span<const Program> programs) const;

private:
    Result<std::vector<std::vector<Finding>>> checkEach(std::span<const Program> programs) const;

    explicit Glslang(TemporaryFolder folder) : m_folder(std::move(folder)) {}

    TemporaryFolder m_folder;
};

} // namespace franken::cli
