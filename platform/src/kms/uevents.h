// SPDX-License-Identifier: MIT
#pragma once

#include "../descriptor.h"

namespace franken::platform {

/// What the kernel says about devices that come, go and change, straight from it (NETLINK_KOBJECT_UEVENT):
/// it needs neither udevd nor rights. An empty descriptor where there is no netlink.
FileDescriptor openUevents();

/// Reads all that is there; whether any of it was about a screen (subsystem drm). True as well where the
/// kernel lost some because nobody read them.
bool readScreenUevents(const FileDescriptor& uevents);

} // namespace franken::platform
