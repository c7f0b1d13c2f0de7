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

/// Writes a file so that its path holds either the old or the complete new file, whenever the disk fills up,
/// the process is killed or the power fails. A regular file is created in the same folder under a random name
/// that nobody can have planted, synced to the disk, and renamed; it keeps the mode of the file that it
/// replaces, and its owner where permitted. A link is followed, and stays. Pipes, terminals and devices are
/// written directly, byte by byte.
///
/// All functions fail with "file.write", and `where` is the path. A file without any write permission bit is
/// refused, for root as well. After a failure no temporary file is left beside the old file.
class FileWriter {
public:
    /// When a file is synced to the disk: by commit(), or, where many are written, by one syncFolder() for
    /// all, which is a hundred times as fast.
    enum class Sync : std::uint8_t { Now, Later };

    /// Begins a new file beside the path; the old one stays until commit(). Fails with "file.write".
    static Result<FileWriter> open(const std::filesystem::path& path, Sync sync = Sync::Now);

    FileWriter(FileWriter&&) noexcept;
    FileWriter& operator=(FileWriter&&) = delete;
    /// Without a commit() before, the old file stays.
    ~FileWriter();

    Result<void> write(std::string_view bytes); ///< Appends. Fails with "file.write".

    /// Syncs the file and renames it to its path. Called once, at the end.
    Result<void> commit();

private:
    struct State;
    explicit FileWriter(std::unique_ptr<State> state);

    std::unique_ptr<State> m_state;
};

/// Writes a whole file at once.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes,
                       FileWriter::Sync sync = FileWriter::Sync::Now);
/// The same for bytes.
Result<void> writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Keeps an output from overwriting its own inputs. Fails with "file.overwrite" where `output` is one of the
/// inputs, by whatever name, or a file in an input that is a folder, at any depth.
Result<void> checkNotInput(const std::filesystem::path& output,
                           std::span<const std::filesystem::path> inputs);

/// Syncs the file system of a folder to the disk, with the writes of all processes.
Result<void> syncFolder(const std::filesystem::path& folder);

/// A lock between threads and processes that read, change and write the same file. It locks the file's
/// folder, so that it survives the file's replacement and leaves nothing behind. On a file system without
/// locks, taking it succeeds without effect.
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
