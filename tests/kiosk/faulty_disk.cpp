// SPDX-License-Identifier: MIT
// The system calls that read and write files, as a broken disk answers them. They are defined in this
// program, so that the linker takes them instead of the C library's. FRANKEN_DISK names a folder: calls for
// files in it fail with EIO where the file FRANKEN_FAULTS has their name at the time ("write fsync"). A file
// is closed all the same, as the kernel does it.
#include "kiosk/faults.h"

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

constexpr int kMostFiles = 1024;
std::atomic<bool> g_isOnDisk[kMostFiles];

bool isOnDisk(int file) { return file >= 0 && file < kMostFiles && g_isOnDisk[file]; }

bool isOnDisk(int folder, const char* path) {
    const char* disk = std::getenv("FRANKEN_DISK");
    if (disk == nullptr)
        return false;
    return path[0] == '/' ? std::strncmp(path, disk, std::strlen(disk)) == 0 : isOnDisk(folder);
}

} // namespace

namespace franken::test {

bool isListed(const char* call) {
    const char* list = std::getenv("FRANKEN_FAULTS");
    if (list == nullptr)
        return false;
    const auto file = static_cast<int>(syscall(SYS_openat, AT_FDCWD, list, O_RDONLY | O_CLOEXEC));
    if (file < 0)
        return false;
    char text[256] = " ";
    const long count = syscall(SYS_read, file, text + 1, sizeof text - 3);
    syscall(SYS_close, file);
    if (count <= 0)
        return false;
    text[1 + count] = ' '; // Then zeros.
    const char* at = std::strstr(text, call);
    return at != nullptr && at[-1] == ' ' && at[std::strlen(call)] == ' ';
}

} // namespace franken::test

namespace {

/// Sets errno where the call is to fail.
bool fails(const char* call) {
    const bool isListed = franken::test::isListed(call);
    errno = isListed ? EIO : errno;
    return isListed;
}

int opened(int folder, const char* path, int flags, int mode) {
    const bool isFaulty = isOnDisk(folder, path);
    const bool writes = (flags & O_ACCMODE) != O_RDONLY;
    if (isFaulty && fails(writes ? "create" : (flags & O_DIRECTORY) != 0 ? "folder" : "open"))
        return -1;
    const auto file = static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
    if (file >= 0 && file < kMostFiles)
        g_isOnDisk[file] = isFaulty;
    return file;
}

int modeOf(int flags, va_list arguments) { return (flags & O_CREAT) != 0 ? va_arg(arguments, int) : 0; }

} // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = modeOf(flags, arguments);
    va_end(arguments);
    return opened(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = modeOf(flags, arguments);
    va_end(arguments);
    return opened(folder, path, flags, mode);
}

ssize_t read(int file, void* bytes, size_t count) {
    return isOnDisk(file) && fails("read") ? -1 : syscall(SYS_read, file, bytes, count);
}

ssize_t write(int file, const void* bytes, size_t count) {
    return isOnDisk(file) && fails("write") ? -1 : syscall(SYS_write, file, bytes, count);
}

int fsync(int file) {
    return isOnDisk(file) && fails("fsync") ? -1 : static_cast<int>(syscall(SYS_fsync, file));
}

int fchmod(int file, mode_t mode) {
    return isOnDisk(file) && fails("fchmod") ? -1 : static_cast<int>(syscall(SYS_fchmod, file, mode));
}

int close(int file) {
    const bool failed = isOnDisk(file) && fails("close");
    if (file >= 0 && file < kMostFiles)
        g_isOnDisk[file] = false;
    const auto closed = static_cast<int>(syscall(SYS_close, file));
    if (failed)
        errno = EIO;
    return failed ? -1 : closed;
}

int renameat(int from, const char* old, int to, const char* name) {
    return isOnDisk(to, name) && fails("rename")
               ? -1
               : static_cast<int>(syscall(SYS_renameat2, from, old, to, name, 0));
}

int unlinkat(int folder, const char* path, int flags) {
    return isOnDisk(folder, path) && fails("unlink")
               ? -1
               : static_cast<int>(syscall(SYS_unlinkat, folder, path, flags));
}

} // extern "C"
