// SPDX-License-Identifier: MIT
#include "uevents.h"

#include <linux/netlink.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <string_view>

namespace franken::platform {

FileDescriptor openUevents() {
    FileDescriptor uevents(
        socket(AF_NETLINK, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_KOBJECT_UEVENT));
    sockaddr_nl address = {};
    address.nl_family = AF_NETLINK;
    address.nl_groups = 1; // The kernel's own; 2 is udevd's.
    if (uevents && bind(uevents.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
        return {};
    return uevents;
}

bool readScreenUevents(const FileDescriptor& uevents) {
    using namespace std::string_view_literals;
    bool found = false;
    std::array<char, 4096> message;
    while (uevents) {
        sockaddr_nl from = {};
        socklen_t length = sizeof from;
        const ssize_t bytes = recvfrom(uevents.get(), message.data(), message.size(), 0,
                                       reinterpret_cast<sockaddr*>(&from), &length);
        if (bytes < 0 && errno == ENOBUFS) {
            found = true;
            continue;
        }
        if (bytes <= 0)
            break;
        const std::string_view text(message.data(), static_cast<std::size_t>(bytes));
        if (from.nl_pid == 0 && text.find("\0SUBSYSTEM=drm\0"sv) != std::string_view::npos)
            found = true;
    }
    return found;
}

} // namespace franken::platform
