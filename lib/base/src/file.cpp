// SPDX-License-Identifier: MIT
#include "franken/file.h"

#include "franken/printable.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace franken {
namespace {

namespace fs = std::filesystem;

Error openError(const fs::path& path, const std::string& reason) {
    return {"file.open", path.string(),
            "the file " + printable(path.filename().string()) + " cannot be read: " + reason,
            "check that it exists, is a file, and may be read"};
}

Error sizeError(const fs::path& path, std::uintmax_t size, std::size_t maxBytes) {
    return {"file.size", path.string(),
            "the file " + printable(path.filename().string()) + " has " + std::to_string(size) +
                " bytes, over the limit of " + std::to_string(maxBytes),
            "make it smaller, or raise the limit"};
}

Result<void> readAll(int file, std::vector<std::uint8_t>& bytes, const fs::path& path) {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = read(file, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return openError(path, count < 0 ? std::strerror(errno) : "it ends early");
        done += static_cast<std::size_t>(count);
    }
    return {};
}

Result<std::vector<std::uint8_t>> readOpen(int file, const fs::path& path, std::size_t maxBytes) {
    struct stat status {};
    if (fstat(file, &status) != 0)
        return openError(path, std::strerror(errno));
    if (!S_ISREG(status.st_mode))
        return openError(path, "it is not a regular file");
    const auto size = static_cast<std::uintmax_t>(status.st_size);
    if (size > maxBytes)
        return sizeError(path, size, maxBytes);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    if (const Result<void> read = readAll(file, bytes, path); !read)
        return read.error();
    return bytes;
}

} // namespace

Descriptor::~Descriptor() {
    if (m_number >= 0)
        close(m_number);
}

Result<std::vector<std::uint8_t>> readFile(const fs::path& path, std::size_t maxBytes) {
    auto bytes = readFileIfThere(path, maxBytes);
    if (!bytes)
        return bytes.error();
    if (!*bytes)
        return openError(path, std::strerror(ENOENT));
    return **std::move(bytes);
}

Result<std::optional<std::vector<std::uint8_t>>> readFileIfThere(const fs::path& path, std::size_t maxBytes) {
    // Without O_NONBLOCK, opening a pipe would wait for its writer.
    const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!file && errno == ENOENT)
        return std::optional<std::vector<std::uint8_t>>();
    if (!file)
        return openError(path, std::strerror(errno));
    return readOpen(file.number(), path, maxBytes).transform([](auto bytes) {
        return std::optional(std::move(bytes));
    });
}

Result<fs::path> findBelow(const fs::path& folder, const fs::path& name) {
    const Error outside{"file.outside", name.string(), "the path leads out of the model's folder",
                        "put the file next to the model, and name it relative to that"};
    if (name.empty() || name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end())
        return outside;
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    const fs::path found = error ? fs::path() : fs::canonical(root / name, error);
    if (error)
        return openError(name, error.message());
    const auto [end, ignored] = std::mismatch(root.begin(), root.end(), found.begin(), found.end());
    if (end != root.end())
        return outside;
    return found;
}

} // namespace franken
