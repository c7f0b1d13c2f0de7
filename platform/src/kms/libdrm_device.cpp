// SPDX-License-Identifier: MIT
#include "../descriptor.h"
#include "../owned.h"
#include "device.h"

#include <fcntl.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace franken::platform {

namespace {

using Resources = Owned<drmModeRes, drmModeFreeResources>;
using Connector = Owned<drmModeConnector, drmModeFreeConnector>;
using Encoder = Owned<drmModeEncoder, drmModeFreeEncoder>;
using Planes = Owned<drmModePlaneRes, drmModeFreePlaneResources>;
using Plane = Owned<drmModePlane, drmModeFreePlane>;
using Properties = Owned<drmModeObjectProperties, drmModeFreeObjectProperties>;
using Property = Owned<drmModePropertyRes, drmModeFreeProperty>;
using Blob = Owned<drmModePropertyBlobRes, drmModeFreePropertyBlob>;
using Request = Owned<drmModeAtomicReq, drmModeAtomicFree>;

static_assert(sizeof(drm_mode_modeinfo) == sizeof(drmModeModeInfo));

/// libdrm sets errno where it returns -1.
int orErrno(int result) { return result == -1 ? -errno : result; }

void readProperties(int device, KmsObject& object, std::uint32_t type) {
    const Properties all(drmModeObjectGetProperties(device, object.id, type));
    for (std::uint32_t i = 0; all && i < all->count_props; ++i) {
        const Property property(drmModeGetProperty(device, all->props[i]));
        if (!property)
            continue;
        KmsProperty& ours = object.properties[property->name];
        ours.id = property->prop_id;
        ours.value = all->prop_values[i];
        for (int choice = 0; choice < property->count_enums; ++choice)
            ours.choices[property->enums[choice].name] = property->enums[choice].value;
    }
}

Connection toConnection(drmModeConnection connection) {
    if (connection == DRM_MODE_CONNECTED)
        return Connection::Connected;
    return connection == DRM_MODE_DISCONNECTED ? Connection::Disconnected : Connection::Unknown;
}

KmsConnector readConnector(int device, const drmModeConnector& from) {
    KmsConnector connector;
    connector.id = from.connector_id;
    const char* type = drmModeGetConnectorTypeName(from.connector_type);
    connector.name =
        std::string(type == nullptr ? "Unknown" : type) + "-" + std::to_string(from.connector_type_id);
    connector.connection = toConnection(from.connection);
    connector.modes.resize(static_cast<std::size_t>(from.count_modes));
    if (from.count_modes > 0)
        std::memcpy(connector.modes.data(), from.modes, connector.modes.size() * sizeof(drm_mode_modeinfo));
    for (int i = 0; i < from.count_encoders; ++i)
        if (const Encoder encoder(drmModeGetEncoder(device, from.encoders[i])); encoder)
            connector.possibleCrtcs |= encoder->possible_crtcs;
    readProperties(device, connector, DRM_MODE_OBJECT_CONNECTOR);
    return connector;
}

void readFormats(int device, const drmModePlane& from, KmsPlane& plane) {
    for (std::uint32_t i = 0; i < from.count_formats; ++i)
        plane.formats[from.formats[i]];
    const KmsProperty* property = plane.find("IN_FORMATS");
    if (property == nullptr || property->value == 0)
        return;
    const Blob blob(drmModeGetPropertyBlob(device, static_cast<std::uint32_t>(property->value)));
    drmModeFormatModifierIterator pair = {};
    while (blob && drmModeFormatModifierBlobIterNext(blob.get(), &pair))
        plane.formats[pair.fmt].push_back(pair.mod);
}

class LibdrmDevice final : public KmsDevice {
public:
    LibdrmDevice(std::string node, FileDescriptor device)
        : m_node(std::move(node)), m_device(std::move(device)) {
        if (drmVersion* version = drmGetVersion(m_device.get()); version != nullptr) {
            m_driver = version->name;
            drmFreeVersion(version);
        }
    }
    ~LibdrmDevice() override { removeBlack(); }

    int descriptor() const override { return m_device.get(); }
    std::string node() const override { return m_node; }
    std::string driver() const override { return m_driver; }
    std::string kernelCommandLine() const override {
        std::string line;
        std::getline(std::ifstream("/proc/cmdline"), line);
        return line;
    }

    int readResources(KmsResources& resources, std::uint32_t probe) override;
    int commit(const KmsRequest& request, std::uint32_t flags, std::uint64_t frame) override;
    int readFlips(std::vector<KmsFlip>& flips) override;

    int addFramebuffer(const KmsBuffer& buffer, std::uint32_t& framebuffer) override;
    void removeFramebuffer(std::uint32_t framebuffer) override { drmModeRmFB(m_device.get(), framebuffer); }
    int addBlack(Size size, std::uint32_t& framebuffer) override;
    void removeBlack() override;
    int addBlob(const void* data, std::size_t bytes, std::uint32_t& blob) override {
        return orErrno(drmModeCreatePropertyBlob(m_device.get(), data, bytes, &blob));
    }
    void removeBlob(std::uint32_t blob) override { drmModeDestroyPropertyBlob(m_device.get(), blob); }

    bool isMaster() override { return drmIsMaster(m_device.get()) != 0; }
    int setMaster() override { return orErrno(drmSetMaster(m_device.get())); }
    int dropMaster() override { return orErrno(drmDropMaster(m_device.get())); }

private:
    std::string m_node, m_driver;
    FileDescriptor m_device;
    std::uint32_t m_blackHandle = 0, m_black = 0;
};

int LibdrmDevice::readResources(KmsResources& resources, std::uint32_t probe) {
    resources = {};
    const int device = m_device.get();
    const Resources from(drmModeGetResources(device));
    if (!from)
        return -errno;
    for (int i = 0; i < from->count_connectors; ++i) {
        const std::uint32_t id = from->connectors[i];
        const bool ask = probe == ~0u || probe == id;
        const Connector connector(ask ? drmModeGetConnector(device, id)
                                      : drmModeGetConnectorCurrent(device, id));
        if (connector && connector->connector_type != DRM_MODE_CONNECTOR_WRITEBACK)
            resources.connectors.push_back(readConnector(device, *connector));
    }
    for (int i = 0; i < from->count_crtcs; ++i) {
        resources.crtcs.push_back({from->crtcs[i], {}});
        readProperties(device, resources.crtcs.back(), DRM_MODE_OBJECT_CRTC);
    }
    const Planes planes(drmModeGetPlaneResources(device));
    for (std::uint32_t i = 0; planes && i < planes->count_planes; ++i) {
        const Plane plane(drmModeGetPlane(device, planes->planes[i]));
        if (!plane)
            continue;
        KmsPlane& ours = resources.planes.emplace_back();
        ours.id = plane->plane_id;
        ours.possibleCrtcs = plane->possible_crtcs;
        readProperties(device, ours, DRM_MODE_OBJECT_PLANE);
        readFormats(device, *plane, ours);
    }
    return 0;
}

int LibdrmDevice::commit(const KmsRequest& request, std::uint32_t flags, std::uint64_t frame) {
    const Request atomic(drmModeAtomicAlloc());
    if (!atomic)
        return -ENOMEM;
    for (const KmsAssignment& set : request)
        if (drmModeAtomicAddProperty(atomic.get(), set.object, set.property, set.value) < 0)
            return -ENOMEM;
    return orErrno(drmModeAtomicCommit(m_device.get(), atomic.get(), flags,
                                       reinterpret_cast<void*>(static_cast<std::uintptr_t>(frame))));
}

int LibdrmDevice::readFlips(std::vector<KmsFlip>& flips) {
    // Eight events at most; what remains keeps the descriptor readable.
    alignas(drm_event) char buffer[8 * sizeof(drm_event_vblank)];
    const ssize_t bytes = read(m_device.get(), buffer, sizeof buffer);
    if (bytes < 0)
        return errno == EAGAIN || errno == EINTR ? 0 : -errno;
    for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(drm_event)) <= bytes;) {
        drm_event head = {};
        std::memcpy(&head, buffer + at, sizeof head);
        if (head.type == DRM_EVENT_FLIP_COMPLETE && head.length >= sizeof(drm_event_vblank)) {
            drm_event_vblank flip = {};
            std::memcpy(&flip, buffer + at, sizeof flip);
            flips.push_back({flip.user_data, flip.sequence,
                             std::chrono::seconds(flip.tv_sec) + std::chrono::microseconds(flip.tv_usec),
                             flip.crtc_id});
        }
        at += head.length;
    }
    return 0;
}

int LibdrmDevice::addFramebuffer(const KmsBuffer& buffer, std::uint32_t& framebuffer) {
    const std::uint32_t handles[4] = {buffer.handle};
    const std::uint32_t strides[4] = {buffer.stride};
    const std::uint32_t offsets[4] = {buffer.offset};
    const auto width = static_cast<std::uint32_t>(buffer.size.width);
    const auto height = static_cast<std::uint32_t>(buffer.size.height);
    const int device = m_device.get();
    if (buffer.modifier == DRM_FORMAT_MOD_INVALID)
        return orErrno(
            drmModeAddFB2(device, width, height, buffer.format, handles, strides, offsets, &framebuffer, 0));
    const std::uint64_t modifiers[4] = {buffer.modifier};
    return orErrno(drmModeAddFB2WithModifiers(device, width, height, buffer.format, handles, strides, offsets,
                                              modifiers, &framebuffer, DRM_MODE_FB_MODIFIERS));
}

int LibdrmDevice::addBlack(Size size, std::uint32_t& framebuffer) {
    removeBlack();
    KmsBuffer buffer{size, DRM_FORMAT_XRGB8888};
    std::uint64_t bytes = 0;
    constexpr std::uint32_t kBitsPerPixel = 32;
    if (const int error = orErrno(drmModeCreateDumbBuffer(
            m_device.get(), static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height),
            kBitsPerPixel, 0, &buffer.handle, &buffer.stride, &bytes)))
        return error; // The kernel hands out zeros.
    m_blackHandle = buffer.handle;
    const int error = addFramebuffer(buffer, m_black);
    framebuffer = m_black;
    return error;
}

void LibdrmDevice::removeBlack() {
    if (m_black != 0)
        removeFramebuffer(std::exchange(m_black, 0));
    if (m_blackHandle != 0)
        drmModeDestroyDumbBuffer(m_device.get(), std::exchange(m_blackHandle, 0));
}

} // namespace

Result<std::unique_ptr<KmsDevice>> openKmsDevice(const std::string& node) {
    FileDescriptor device(open(node.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
    if (!device && (errno == EACCES || errno == EPERM))
        return Error{"screen.permission", node, "it may not be opened",
                     "put the user into the groups video and render"};
    if (!device)
        return Error{"screen.no-device", node, std::strerror(errno), "check that the driver is loaded"};
    const Resources resources(drmModeGetResources(device.get()));
    if (!resources || resources->count_connectors == 0)
        return Error{"screen.unsupported", node, "the device has no screen outputs", ""};
    if (drmSetClientCap(device.get(), DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) != 0 ||
        drmSetClientCap(device.get(), DRM_CLIENT_CAP_ATOMIC, 1) != 0)
        return Error{"screen.unsupported", node, "the driver has no atomic mode setting",
                     "use the KMS driver of the kernel (dtoverlay=vc4-kms-v3d)"};
    return std::unique_ptr<KmsDevice>(std::make_unique<LibdrmDevice>(node, std::move(device)));
}

} // namespace franken::platform
