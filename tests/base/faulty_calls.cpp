// SPDX-License-Identifier: MIT
// The system calls of lib/base, one of which fails. They are defined in this program, so that the linker
// takes them instead of the C library's. FRANKEN_FAULT is "N ERRNO": call N and all after it fail with that
// number, or with ERRNO 0 the process ends there as by a power cut. With "N ERRNO alone", those after it
// succeed. A file is closed and removed all the same (only a broken disk, EIO, removes nothing), as the
// kernel does it. The calls are counted from countCalls() on.
#include "faulty_calls.h"

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

int g_calls = -1; // Not counted yet.
int g_at = 0, g_error = 0;
bool g_alone = false;
char g_names[4096]; // No string, because its memory is another library's.

void note(const char* name) {
    if (g_calls >= 0 && std::strlen(g_names) + std::strlen(name) + 2 < sizeof g_names)
        std::strcat(std::strcat(g_names, name), " ");
}

// Whether this call is to fail.
bool fails(const char* name) {
    note(name);
    if (g_calls < 0 || ++g_calls < g_at || g_at == 0 || (g_alone && g_calls > g_at))
        return false;
    if (g_error == 0)
        raise(SIGKILL);
    errno = g_error;
    return true;
}

int modeOf(int flags, va_list arguments) { return (flags & O_CREAT) != 0 ? va_arg(arguments, int) : 0; }

} // namespace

int countCalls() {
    if (g_calls < 0) {
        if (const char* fault = std::getenv("FRANKEN_FAULT")) {
            std::sscanf(fault, "%d %d", &g_at, &g_error);
            g_alone = std::strstr(fault, "alone") != nullptr;
        }
        g_calls = 0;
    }
    return g_calls;
}

const char* namesOfCalls() { return g_names; }

extern "C" {

// A writer whose random names are known, to plant files of that name.
ssize_t getrandom(void* bytes, size_t count, unsigned flags) {
    if (std::getenv("FRANKEN_NO_RANDOM") == nullptr)
        return syscall(SYS_getrandom, bytes, count, flags);
    std::memset(bytes, 0, count);
    return static_cast<ssize_t>(count);
}

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = modeOf(flags, arguments);
    va_end(arguments);
    return fails("open") ? -1 : static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int openat(int folder, const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const int mode = modeOf(flags, arguments);
    va_end(arguments);
    return fails("openat") ? -1 : static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

ssize_t read(int file, void* bytes, size_t count) {
    return fails("read") ? -1 : syscall(SYS_read, file, bytes, count);
}

ssize_t write(int file, const void* bytes, size_t count) {
    // A disk that fills up takes a part first.
    if (g_calls >= 0 && count > 1 && g_at > 0 && g_calls + 1 == g_at && g_error != 0) {
        ++g_calls;
        note("write");
        return syscall(SYS_write, file, bytes, count / 2);
    }
    return fails("write") ? -1 : syscall(SYS_write, file, bytes, count);
}

int fsync(int file) {
    struct stat status {};
    const bool folder = fstatat(file, "", &status, AT_EMPTY_PATH) == 0 && S_ISDIR(status.st_mode);
    return fails(folder ? "fsync/" : "fsync") ? -1 : static_cast<int>(syscall(SYS_fsync, file));
}

int fchmod(int file, mode_t mode) {
    return fails("fchmod") ? -1 : static_cast<int>(syscall(SYS_fchmod, file, mode));
}
int flock(int file, int operation) {
    return fails("flock") ? -1 : static_cast<int>(syscall(SYS_flock, file, operation));
}

int fchown(int file, uid_t owner, gid_t group) {
    return fails("fchown") ? -1 : static_cast<int>(syscall(SYS_fchown, file, owner, group));
}

int stat(const char* path, struct stat* status) {
    return fails("stat") ? -1 : fstatat(AT_FDCWD, path, status, 0);
}

int lstat(const char* path, struct stat* status) {
    return fails("lstat") ? -1 : fstatat(AT_FDCWD, path, status, AT_SYMLINK_NOFOLLOW);
}

int fstat(int file, struct stat* status) {
    return fails("fstat") ? -1 : fstatat(file, "", status, AT_EMPTY_PATH);
}

ssize_t readlink(const char* path, char* target, size_t size) {
    return fails("readlink") ? -1 : readlinkat(AT_FDCWD, path, target, size);
}

int close(int file) {
    const bool failed = fails("close");
    const int closed = static_cast<int>(syscall(SYS_close, file));
    if (failed)
        errno = g_error;
    return failed ? -1 : closed;
}

int syncfs(int file) { return fails("syncfs") ? -1 : static_cast<int>(syscall(SYS_syncfs, file)); }

int unlinkat(int folder, const char* path, int flags) {
    const bool failed = fails("unlinkat") && g_error == EIO;
    return failed ? -1 : static_cast<int>(syscall(SYS_unlinkat, folder, path, flags));
}

int renameat(int from, const char* old, int to, const char* name) {
    return fails("renameat") ? -1 : static_cast<int>(syscall(SYS_renameat2, from, old, to, name, 0));
}

} // extern "C"
