// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace FRANKEN_API franken {

/// Writes a file so that it is the old one or the whole new one, whenever the disk fills up, the process is
/// killed or the power goes. A regular file is made beside its place under a random name that nobody can have
/// planted, brought to the disk, and renamed; it keeps the mode, and where it may the owner, of the file that
/// it replaces. A link is followed, and stays. What is no regular file (a pipe, a terminal, a device) is
/// written to as it is, byte by byte.
///
/// All functions fail with "file.write", `where` being the path: what cannot be written, why, and what to do.
/// A file that nobody may write to (no mode bit for it) is refused, for root as well. After a failure nothing
/// is left beside the old file.
class FileWriter {
public:
    /// When a file is brought to the disk: by commit(), or, where many are written, by one syncFolder() for
    /// all, which a disk does a hundred times as fast.
    enum class Sync : std::uint8_t { Now, Later };

    static Result<FileWriter> open(const std::filesystem::path& path, Sync sync = Sync::Now);

    FileWriter(FileWriter&&) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    /// Without commit() before it, the file stays as it was.
    ~FileWriter();

    Result<void> write(std::string_view bytes);

    /// Puts the file in its place, on the disk. Called once, at the end.
    Result<void> commit();

private:
    struct State;
    explicit FileWriter(std::unique_ptr<State> state);

    std::unique_ptr<State> m_state;
};

/// The whole of a file at once.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes,
                       FileWriter::Sync sync = FileWriter::Sync::Now);
Result<void> writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Keeps an output from destroying what it is made of. Fails with "file.overwrite" where it is one of the
/// inputs, by whatever name; of an input that is a folder, where it is a file in it.
Result<void> checkNotInput(const std::filesystem::path& output,
                           std::span<const std::filesystem::path> inputs);

/// Brings to the disk what was written to a folder's file system, by whomever.
Result<void> syncFolder(const std::filesystem::path& folder);

/// Keeps others who take it, threads and processes, from a file while it is read, changed and written again.
/// It is a lock on the file's folder, so that it outlives the file's replacement and leaves nothing behind. A
/// file system that knows no locks gives it all the same.
class FileLock {
public:
    /// Waits for at most ten seconds. Fails with "file.lock".
    static Result<FileLock> take(const std::filesystem::path& file);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock();

private:
    explicit FileLock(int folder) : m_folder(folder) {}

    int m_folder; ///< A descriptor; -1 where it was moved from.
};

} // namespace franken
