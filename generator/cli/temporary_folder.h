// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

#include <filesystem>

namespace franken::cli {

/// A folder of our own below TMPDIR, which goes with all that is in it.
class TemporaryFolder {
public:
    /// Fails with "temporary.folder".
    static Result<TemporaryFolder> make();

    TemporaryFolder(TemporaryFolder&& other) noexcept;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return m_path; }

private:
    explicit TemporaryFolder(std::filesystem::path path);

    std::filesystem::path m_path; ///< Empty where it was moved from.
};

} // namespace franken::cli
