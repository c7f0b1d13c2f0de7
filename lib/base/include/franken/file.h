// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "franken/api.h"
#include "franken/result.h"

namespace FRANKEN_API franken {

/// A file descriptor, closed by the destructor; false where open() failed.
class Descriptor {
public:
    /// Takes over a descriptor; -1 for none.
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    /// There is one.
    explicit operator bool() const { return m_number >= 0; }
    /// -1 for none; stays owned.
    int number() const { return m_number; }

private:
    int m_number;
};

/// The contents of a regular file; directories, devices and pipes are refused. Fails with
///
///     file.open    it is not there, may not be read, or is no regular file
///     file.size    it is larger than `maxBytes`; nothing was read
///
/// `where` is the path.
Result<std::vector<std::uint8_t>> readFile(const std::filesystem::path& path, std::size_t maxBytes);

/// The same, but a missing file is not an error: the result is then std::nullopt. For callers that create a
/// missing file and must not mistake an unreadable disk for a first start.
Result<std::optional<std::vector<std::uint8_t>>> readFileIfThere(const std::filesystem::path& path,
                                                                 std::size_t maxBytes);

/// The file of that name in `folder` or below, without symbolic links. Fails with "file.outside" where the
/// name is absolute, or leads out of the folder by ".." or by a symbolic link; with "file.open" where there
/// is no such file. `where` is the name.
Result<std::filesystem::path> findBelow(const std::filesystem::path& folder,
                                        const std::filesystem::path& name);

} // namespace franken
