// SPDX-License-Identifier: MIT
// The kernel's screen, which is too busy for a frame where FRANKEN_FAULTS lists "commit".
#include "kiosk/faults.h"

#include <dlfcn.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cerrno>

extern "C" int drmModeAtomicCommit(int device, drmModeAtomicReqPtr request, uint32_t flags, void* user) {
    if ((flags & DRM_MODE_ATOMIC_TEST_ONLY) == 0 && franken::test::isListed("commit"))
        return -EBUSY;
    static const auto commit =
        reinterpret_cast<decltype(&drmModeAtomicCommit)>(dlsym(RTLD_NEXT, "drmModeAtomicCommit"));
    return commit(device, request, flags, user);
}
