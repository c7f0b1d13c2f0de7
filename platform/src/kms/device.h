// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/screen.h"

#include <drm_fourcc.h>
#include <drm_mode.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace franken::platform {

/// A property of an object, as the kernel has it.
struct KmsProperty {
    std::uint32_t id = 0;
    std::uint64_t value = 0;
    std::map<std::string, std::uint64_t> choices; ///< Of an enumeration.
};

/// A connector, CRTC or plane.
struct KmsObject {
    std::uint32_t id = 0;
    std::map<std::string, KmsProperty> properties;

    /// Null where the driver has none of that name.
    const KmsProperty* find(const std::string& name) const;
    std::uint64_t value(const std::string& name) const;
    /// The word for the value of an enumeration; empty where there is none.
    std::string word(const std::string& name) const;
};

struct KmsConnector : KmsObject {
    std::string name; ///< "HDMI-A-1".
    Connection connection = Connection::Unknown;
    std::vector<drm_mode_modeinfo> modes;
    std::uint32_t possibleCrtcs = 0; ///< Bits of KmsResources::crtcs, by any of its encoders.
};

struct KmsPlane : KmsObject {
    std::uint32_t possibleCrtcs = 0; ///< Bits of KmsResources::crtcs.
    /// What it takes by IN_FORMATS: modifiers of each format (fourcc). A format without modifiers where the
    /// driver has no IN_FORMATS.
    std::map<std::uint32_t, std::vector<std::uint64_t>> formats;
};

struct KmsResources {
    std::vector<KmsConnector> connectors; ///< Without writeback connectors.
    std::vector<KmsObject> crtcs;
    std::vector<KmsPlane> planes;
};

/// What an atomic commit sets.
struct KmsAssignment {
    std::uint32_t object, property;
    std::uint64_t value;
};
using KmsRequest = std::vector<KmsAssignment>;

/// A buffer that may be scanned out, with one plane.
struct KmsBuffer {
    Size size;
    std::uint32_t format = 0; ///< Fourcc.
    std::uint64_t modifier = DRM_FORMAT_MOD_INVALID;
    std::uint32_t handle = 0, stride = 0, offset = 0;
};

struct KmsFlip {
    std::uint64_t frame; ///< What commit() was given.
    std::uint32_t sequence;
    std::chrono::nanoseconds time;
    std::uint32_t crtc; ///< A commit to two CRTCs is answered by each.
};

/// The calls of the kernel's mode setting that this library makes, and all of them: what a test puts a
/// fake in place of, or an error between. Calls return 0 or a negative errno.
class KmsDevice {
public:
    virtual ~KmsDevice() = default;

    virtual int descriptor() const = 0; ///< Readable when readFlips() has something.
    virtual std::string node() const = 0;
    virtual std::string driver() const = 0;
    virtual std::string kernelCommandLine() const = 0;

    /// Everything as it is now. The connector with the id `probe` is asked by its wires (slow: tens of
    /// milliseconds with EDID), all if that is ~0; others as the kernel last knew them.
    virtual int readResources(KmsResources& resources, std::uint32_t probe) = 0;
    virtual int commit(const KmsRequest& request, std::uint32_t flags, std::uint64_t frame) = 0;
    virtual int readFlips(std::vector<KmsFlip>& flips) = 0;

    virtual int addFramebuffer(const KmsBuffer& buffer, std::uint32_t& framebuffer) = 0;
    virtual void removeFramebuffer(std::uint32_t framebuffer) = 0;
    /// A framebuffer of XRGB8888 zeros that lives as long as the device, or until removeBlack().
    virtual int addBlack(Size size, std::uint32_t& framebuffer) = 0;
    virtual void removeBlack() = 0;
    virtual int addBlob(const void* data, std::size_t bytes, std::uint32_t& blob) = 0;
    virtual void removeBlob(std::uint32_t blob) = 0;

    virtual bool isMaster() = 0;
    virtual int setMaster() = 0;
    virtual int dropMaster() = 0;
};

/// Opens a node and asks for what this library needs (atomic, universal planes). Fails with
/// `screen.permission`, `screen.no-device`, or `screen.unsupported` for a node that cannot set modes.
Result<std::unique_ptr<KmsDevice>> openKmsDevice(const std::string& node);

} // namespace franken::platform
