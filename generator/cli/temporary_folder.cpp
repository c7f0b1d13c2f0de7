// SPDX-License-Identifier: MIT
#include "temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace franken::cli {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder(fs::path path) : m_path(std::move(path)) {}
TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : m_path(std::exchange(other.m_path, {})) {}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    if (!m_path.empty())
        fs::remove_all(m_path, ignored);
}

Result<TemporaryFolder> TemporaryFolder::make() {
    std::error_code failed;
    std::string pattern = (fs::temp_directory_path(failed) / "frankenshader.XXXXXX").string();
    if (failed || !mkdtemp(pattern.data()))
        return Error{"temporary.folder", "TMPDIR", failed ? failed.message() : std::strerror(errno),
                     "set TMPDIR to a folder with write permission"};
    return TemporaryFolder(pattern);
}

} // namespace franken::cli
