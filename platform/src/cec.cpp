// SPDX-License-Identifier: MIT
#include "franken/platform/cec.h"

#include "descriptor.h"

#include <fcntl.h>
#include <linux/cec.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <cstring>

namespace franken::platform {

namespace {

class KernelCec final : public CecCalls {
public:
    explicit KernelCec(FileDescriptor device) : m_device(std::move(device)) {}
    int call(unsigned long request, void* argument) override {
        return ioctl(m_device.get(), request, argument) < 0 ? -errno : 0;
    }

private:
    FileDescriptor m_device;
};

Error failed(const char* call, int error) {
    return Error{"cec.driver", call, std::strerror(-error), "switch CEC on in the television set's menu"};
}

} // namespace

Result<Cec> Cec::open(const std::string& device) {
    FileDescriptor opened(::open(device.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
    if (!opened && (errno == EACCES || errno == EPERM))
        return Error{"cec.permission", device, "it may not be opened", "put the user into the group video"};
    if (!opened)
        return Error{"cec.missing", device, std::strerror(errno), "only HDMI has it"};
    return Cec(std::make_unique<KernelCec>(std::move(opened)));
}

Result<int> Cec::becomePlayer() {
    cec_log_addrs addresses = {};
    if (const int error = m_calls->call(CEC_ADAP_G_LOG_ADDRS, &addresses); error != 0)
        return failed("CEC_ADAP_G_LOG_ADDRS", error);
    if (addresses.num_log_addrs == 0) {
        addresses = {};
        addresses.cec_version = CEC_OP_CEC_VERSION_1_4;
        addresses.num_log_addrs = 1;
        addresses.vendor_id = CEC_VENDOR_ID_NONE;
        addresses.primary_device_type[0] = CEC_OP_PRIM_DEVTYPE_PLAYBACK;
        addresses.log_addr_type[0] = CEC_LOG_ADDR_TYPE_PLAYBACK;
        std::strncpy(addresses.osd_name, "Kiosk", sizeof addresses.osd_name - 1);
        if (const int error = m_calls->call(CEC_ADAP_S_LOG_ADDRS, &addresses); error != 0)
            return failed("CEC_ADAP_S_LOG_ADDRS", error);
    }
    // The kernel fills it in when the bus has agreed, in a moment; until then one speaks as nobody in
    // particular.
    const int address = addresses.log_addr[0];
    return addresses.log_addr_mask == 0 || address > CEC_LOG_ADDR_UNREGISTERED ? CEC_LOG_ADDR_UNREGISTERED
                                                                               : address;
}

Result<void> Cec::send(int from, int to, std::initializer_list<unsigned char> message) {
    cec_msg out = {};
    out.len = 1;
    out.msg[0] = static_cast<unsigned char>(from << 4 | to);
    for (const unsigned char byte : message)
        out.msg[out.len++] = byte;
    const int error = m_calls->call(CEC_TRANSMIT, &out);
    if (error == -ENETDOWN || error == -ENONET)
        return Error{"cec.no-screen", "CEC_TRANSMIT", "no connected screen reports a CEC address",
                     "plug in the television set"};
    return error == 0 ? Result<void>() : failed("CEC_TRANSMIT", error);
}

Result<void> Cec::standby() {
    return becomePlayer().and_then(
        [this](int self) { return send(self, CEC_LOG_ADDR_TV, {CEC_MSG_STANDBY}); });
}

Result<void> Cec::wake() {
    const Result<int> self = becomePlayer();
    if (!self)
        return self.error();
    if (Result<void> woken = send(*self, CEC_LOG_ADDR_TV, {CEC_MSG_IMAGE_VIEW_ON}); !woken)
        return woken;
    __u16 physical = CEC_PHYS_ADDR_INVALID;
    if (const int error = m_calls->call(CEC_ADAP_G_PHYS_ADDR, &physical); error != 0)
        return failed("CEC_ADAP_G_PHYS_ADDR", error);
    return send(*self, CEC_LOG_ADDR_BROADCAST,
                {CEC_MSG_ACTIVE_SOURCE, static_cast<unsigned char>(physical >> 8),
                 static_cast<unsigned char>(physical & 0xFF)});
}

} // namespace franken::platform
