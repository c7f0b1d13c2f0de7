// SPDX-License-Identifier: MIT
//
// Only the master may ask for a copy of what is scanned out, so this goes through the descriptor that the
// program under test has open.
#include "support/guest.h"

#include <drm_fourcc.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstring>
#include <filesystem>
#include <list>
#include <vector>

namespace franken::test {

namespace {

std::uint32_t property(int device, std::uint32_t object, std::uint32_t type, const char* name) {
    std::uint32_t found = 0;
    drmModeObjectProperties* all = drmModeObjectGetProperties(device, object, type);
    for (std::uint32_t i = 0; all != nullptr && i < all->count_props; ++i) {
        drmModePropertyRes* one = drmModeGetProperty(device, all->props[i]);
        if (std::strcmp(one->name, name) == 0)
            found = one->prop_id;
        drmModeFreeProperty(one);
    }
    drmModeFreeObjectProperties(all);
    return found;
}

std::uint32_t writebackConnector(int device, const drmModeRes& resources) {
    std::uint32_t found = 0;
    for (int i = 0; i < resources.count_connectors; ++i) {
        drmModeConnector* connector = drmModeGetConnectorCurrent(device, resources.connectors[i]);
        if (connector->connector_type == DRM_MODE_CONNECTOR_WRITEBACK)
            found = connector->connector_id;
        drmModeFreeConnector(connector);
    }
    return found;
}

/// A buffer to write to.
struct Copy {
    int device;
    std::uint32_t bits, handle = 0, stride = 0, framebuffer = 0;
    std::uint64_t bytes = 0;

    Copy(int onDevice, std::uint32_t width, std::uint32_t height, std::uint32_t fourcc)
        : device(onDevice), bits(fourcc == DRM_FORMAT_RGB565 ? 16 : 32) {
        drmModeCreateDumbBuffer(device, width, height, bits, 0, &handle, &stride, &bytes);
        const std::uint32_t handles[4] = {handle}, strides[4] = {stride}, offsets[4] = {};
        drmModeAddFB2(device, width, height, fourcc, handles, strides, offsets, &framebuffer, 0);
    }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;
    ~Copy() {
        drmModeRmFB(device, framebuffer);
        drmModeDestroyDumbBuffer(device, handle);
    }
};

std::uint32_t widened(std::uint16_t pixel) {
    const std::uint32_t red = pixel >> 11, green = pixel >> 5 & 63, blue = pixel & 31;
    return (red << 3 | red >> 2) << 16 | (green << 2 | green >> 4) << 8 | (blue << 3 | blue >> 2);
}

VmPicture read(const Copy& copy, platform::Size size) {
    VmPicture picture{size, {}};
    std::uint64_t offset = 0;
    drmModeMapDumbBuffer(copy.device, copy.handle, &offset);
    void* memory = mmap(nullptr, copy.bytes, PROT_READ, MAP_SHARED, copy.device, static_cast<off_t>(offset));
    for (int y = 0; memory != MAP_FAILED && y < size.height; ++y) {
        const char* row = static_cast<const char*>(memory) + static_cast<std::size_t>(y) * copy.stride;
        for (int x = 0; x < size.width; ++x)
            picture.pixels.push_back(copy.bits == 16
                                         ? widened(reinterpret_cast<const std::uint16_t*>(row)[x])
                                         : reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFF);
    }
    munmap(memory, copy.bytes);
    return picture;
}

int commit(int device, std::uint32_t connector, std::uint32_t crtc, const Copy* copy, int* fence) {
    drmModeAtomicReq* request = drmModeAtomicAlloc();
    const auto add = [&](const char* name, std::uint64_t value) {
        drmModeAtomicAddProperty(request, connector,
                                 property(device, connector, DRM_MODE_OBJECT_CONNECTOR, name), value);
    };
    add("CRTC_ID", crtc);
    add("WRITEBACK_FB_ID", copy == nullptr ? 0 : copy->framebuffer);
    if (fence != nullptr)
        add("WRITEBACK_OUT_FENCE_PTR", reinterpret_cast<std::uintptr_t>(fence));
    const int result = drmModeAtomicCommit(device, request, DRM_MODE_ATOMIC_ALLOW_MODESET, nullptr);
    drmModeAtomicFree(request);
    return result;
}

} // namespace

int screenDescriptor(pid_t process) {
    const std::string folder = "/proc/" + std::to_string(process) + "/fd";
    const int handle = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
    int found = -1;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::error_code error;
        if (!std::filesystem::read_symlink(entry.path(), error).string().starts_with("/dev/dri/card"))
            continue;
        const int number = std::stoi(entry.path().filename());
        const int copy = static_cast<int>(syscall(SYS_pidfd_getfd, handle, number, 0));
        if (found < 0 && copy >= 0 && drmIsMaster(copy) != 0)
            found = copy;
        else if (copy >= 0)
            close(copy);
    }
    close(handle);
    return found;
}

VmPicture scannedOut(std::uint32_t fourcc, pid_t process) {
    const int device = screenDescriptor(process);
    EXPECT_GE(device, 0) << "process " << process << " is not the screen's master";
    if (device < 0)
        return {};
    drmSetClientCap(device, DRM_CLIENT_CAP_WRITEBACK_CONNECTORS, 1);
    drmModeRes* resources = drmModeGetResources(device);
    drmModeCrtc* crtc = drmModeGetCrtc(device, resources->crtcs[0]);
    const platform::Size size{static_cast<int>(crtc->mode.hdisplay), static_cast<int>(crtc->mode.vdisplay)};
    const std::uint32_t connector = writebackConnector(device, *resources);
    VmPicture picture;
    std::list<Copy> copies;
    std::vector<pollfd> fences;
    // A frame that the program commits before the next refresh takes the copy's place, and the copy never
    // comes.
    for (bool isWritten = false; !isWritten && copies.size() < 5;) {
        const Copy& copy = copies.emplace_back(device, crtc->mode.hdisplay, crtc->mode.vdisplay, fourcc);
        int fence = -1;
        EXPECT_EQ(commit(device, connector, crtc->crtc_id, &copy, &fence), 0);
        fences.push_back({fence, POLLIN, 0});
        isWritten = poll(fences.data(), fences.size(), 600) > 0; // The oldest is answered first.
        EXPECT_TRUE(isWritten || copies.size() < 5) << "nothing was written";
    }
    picture = read(copies.back(), size);
    EXPECT_EQ(commit(device, connector, 0, nullptr, nullptr), 0);
    for (const pollfd& fence : fences)
        close(fence.fd);
    copies.clear(); // Before its device is closed.
    drmModeFreeCrtc(crtc);
    drmModeFreeResources(resources);
    close(device);
    return picture;
}

} // namespace franken::test
