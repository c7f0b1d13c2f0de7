// SPDX-License-Identifier: MIT
#include "franken/file_writer.h"

#include "franken/file.h"
#include "franken/printable.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace franken {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNameBytes =
    200; // Of the 255 that a name may have: the rest is for the random part.

const char* remedyFor(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "make room on the disk, or name a file on another one";
    case ENOENT:
    case ENOTDIR:
        return "make its folder first, or name another one";
    case EISDIR:
        return "name a file in it";
    case EACCES:
    case EPERM:
    case EROFS:
        return "see that the file and its folder may be written to, or name another one";
    case EMFILE:
    case ENFILE:
        return "close files, or raise the limit of open ones";
    default:
        return "check the folder, its permissions and the space left";
    }
}

Error writeError(const fs::path& path, int error) {
    return {"file.write", path.string(), std::string("cannot be written: ") + std::strerror(error),
            remedyFor(error)};
}

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

template<typename Call>
int retried(Call call) {
    int result;
    do
        result = call();
    while (result < 0 && errno == EINTR);
    return result;
}

/// Where the file is that the path's links lead to, whether it exists or not. Nothing for what /proc links to
/// (/dev/stdout): such a link names an open file, not a place. `error` is set where that cannot be told: what
/// is there might be a link, which must not be replaced.
std::optional<fs::path> placeOf(fs::path path, std::error_code& error) {
    constexpr int kMaxLinks = 40; // As the kernel has it.
    for (int links = 0; links <= kMaxLinks; ++links) {
        const fs::path folder = fs::canonical(folderOf(path), error);
        if (error)
            return path;
        if (const auto root = ++folder.begin(); root != folder.end() && *root == "proc")
            return std::nullopt;
        const fs::file_type type = fs::symlink_status(folder / path.filename(), error).type();
        if (type == fs::file_type::not_found)
            error.clear();
        if (error || type != fs::file_type::symlink)
            return folder / path.filename();
        const fs::path target = fs::read_symlink(folder / path.filename(), error);
        if (error)
            return path;
        path = folder / target;
    }
    error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    return path;
}

std::string randomName(const fs::path& name) {
    std::uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number)
        number = static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count()) ^
                 static_cast<std::uint64_t>(getpid()) << 32U;
    char suffix[32];
    std::snprintf(suffix, sizeof suffix, ".%016llx.new", static_cast<unsigned long long>(number));
    return "." + name.string().substr(0, kMaxNameBytes) + suffix;
}

/// File systems that cannot bring a file or folder to the disk say EINVAL, and do what they can.
bool sync(int descriptor) {
    return retried([&] { return fsync(descriptor); }) == 0 || errno == EINVAL || errno == ENOTSUP;
}

/// Whether the absolute path leads through the folder, by whatever name that goes.
bool isBelow(fs::path path, const fs::path& folder) {
    std::error_code ignored;
    while (path.has_relative_path()) {
        path = path.parent_path();
        if (fs::equivalent(path, folder, ignored))
            return true;
    }
    return false;
}

} // namespace

struct FileWriter::State {
    fs::path path;
    std::string name, temporary; // In `folder`. Without a temporary, the file is written to as it is.
    int folder = -1, file = -1;
    Sync when = Sync::Now;

    ~State() {
        if (file >= 0)
            close(file);
        if (!temporary.empty())
            unlinkat(folder, temporary.c_str(), 0);
        if (folder >= 0)
            close(folder);
    }

    bool openAsItIs() {
        file = retried([&] { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
        return file >= 0;
    }

    /// The file that is to be replaced gives its mode, and its owner where we may give files away.
    bool takeOver(const struct stat& old) {
        if (old.st_uid != geteuid() || old.st_gid != getegid())
            if (fchown(file, old.st_uid, old.st_gid) != 0 && errno != EPERM)
                return false;
        return fchmod(file, old.st_mode & 0777U) == 0;
    }

    bool openBeside(const fs::path& place, const struct stat* old) {
        name = place.filename().string();
        if (old && ((old->st_mode & 0222U) == 0 || access(place.c_str(), W_OK) != 0))
            return errno = EACCES, false;
        folder = retried([&] { return ::open(folderOf(place).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
        if (folder < 0)
            return false;
        constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
        std::string random = randomName(place.filename());
        file = retried([&] { return openat(folder, random.c_str(), kFlags, old ? 0600 : 0666); });
        if (file < 0)
            return false;
        temporary = std::move(random);
        return !old || takeOver(*old);
    }

    bool open() {
        struct stat old {};
        const bool exists = stat(path.c_str(), &old) == 0;
        if (!exists && errno != ENOENT)
            return false;
        if (exists && S_ISDIR(old.st_mode))
            return errno = EISDIR, false;
        if (path.filename().empty())
            return errno = ENOENT, false;
        std::error_code error;
        const std::optional<fs::path> place = placeOf(path, error);
        if (error)
            return errno = error.value(), false;
        if (!place || (exists && !S_ISREG(old.st_mode)))
            return openAsItIs();
        return openBeside(*place, exists ? &old : nullptr);
    }

    bool write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(file, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR)
                return false;
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
        return true;
    }

    bool commit() {
        const bool replaces = !temporary.empty();
        if (when == Sync::Now && !sync(file))
            return false;
        if (close(std::exchange(file, -1)) != 0 && errno != EINTR)
            return false;
        if (!replaces)
            return true;
        if (renameat(folder, temporary.c_str(), folder, name.c_str()) != 0)
            return false;
        temporary.clear();
        return when == Sync::Later || sync(folder);
    }
};

FileWriter::FileWriter(std::unique_ptr<State> state) : m_state(std::move(state)) {}
FileWriter::FileWriter(FileWriter&&) noexcept = default;
FileWriter::~FileWriter() = default;

Result<FileWriter> FileWriter::open(const fs::path& path, Sync sync) {
    auto state = std::make_unique<State>();
    state->when = sync;
    state->path = path;
    if (!state->open())
        return writeError(path, errno);
    return FileWriter(std::move(state));
}

Result<void> FileWriter::write(std::string_view bytes) {
    if (!m_state->write(bytes))
        return writeError(m_state->path, errno);
    return {};
}

Result<void> FileWriter::commit() {
    if (!m_state->commit())
        return writeError(m_state->path, errno);
    return {};
}

Result<void> writeFile(const fs::path& path, std::string_view bytes, FileWriter::Sync sync) {
    Result<FileWriter> file = FileWriter::open(path, sync);
    if (!file)
        return file.error();
    if (Result<void> written = file->write(bytes); !written)
        return written;
    return file->commit();
}

Result<void> writeFile(const fs::path& path, std::span<const std::uint8_t> bytes) {
    return writeFile(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

Result<void> checkNotInput(const fs::path& output, std::span<const fs::path> inputs) {
    std::error_code ignored;
    const fs::path place = placeOf(output, ignored).value_or(output);
    for (const fs::path& input : inputs) {
        const bool same = fs::is_regular_file(input, ignored) && fs::equivalent(input, output, ignored);
        const bool inside =
            fs::is_directory(input, ignored) && fs::exists(output, ignored) && isBelow(place, input);
        if (same || inside)
            return Error{"file.overwrite", output.string(),
                         "the output would overwrite " + std::string(inside ? "a file of " : "") +
                             printable(input.string()) + ", which is an input",
                         "choose another output file"};
    }
    return {};
}

Result<void> syncFolder(const fs::path& folder) {
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!opened || syncfs(opened.number()) != 0)
        return writeError(folder, errno);
    return {};
}

FileLock::FileLock(FileLock&& other) noexcept : m_folder(std::exchange(other.m_folder, -1)) {}

FileLock::~FileLock() {
    if (m_folder >= 0)
        close(m_folder);
}

Result<FileLock> FileLock::take(const fs::path& file) {
    using namespace std::chrono_literals;
    constexpr int kTries = 2000;
    const auto failed = [&](int error) {
        return Error{"file.lock", file.string(),
                     std::string("cannot be locked: ") +
                         (error == EWOULDBLOCK ? "another process holds the lock" : std::strerror(error)),
                     error == EWOULDBLOCK ? "wait for the other process" : remedyFor(error)};
    };
    std::error_code error;
    const fs::path folder = folderOf(placeOf(file, error).value_or(file));
    if (error)
        return failed(error.value());
    FileLock lock(retried([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
    if (lock.m_folder < 0)
        return failed(errno);
    for (int i = 0; i < kTries; ++i) {
        if (flock(lock.m_folder, LOCK_EX | LOCK_NB) == 0 || errno == ENOTSUP || errno == ENOSYS ||
            errno == EBADF)
            return lock;
        if (errno != EWOULDBLOCK && errno != EINTR)
            return failed(errno);
        std::this_thread::sleep_for(5ms);
    }
    return failed(EWOULDBLOCK);
}

} // namespace franken
