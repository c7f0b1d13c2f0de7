// SPDX-License-Identifier: MIT
//
// What is said to a television set, against a fake of the kernel's calls.
#include "franken/platform/cec.h"

#include <gtest/gtest.h>
#include <linux/cec.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <map>
#include <vector>

namespace franken::platform {
namespace {

using Bytes = std::vector<int>;

/// An adapter at the physical address 2.1.0.0 that gets the logical address 4 when it asks for one.
struct FakeCec final : CecCalls {
    struct State {
        bool claimed = false;
        std::vector<Bytes> sent;
        std::map<unsigned long, int> errors;
    };
    State& state;
    explicit FakeCec(State& of) : state(of) {}

    int call(unsigned long request, void* argument) override {
        if (const auto error = state.errors.find(request); error != state.errors.end())
            return error->second;
        if (request == CEC_TRANSMIT) {
            const auto* message = static_cast<const cec_msg*>(argument);
            state.sent.emplace_back(message->msg, message->msg + message->len);
        }
        auto* addresses = static_cast<cec_log_addrs*>(argument);
        if (request == CEC_ADAP_S_LOG_ADDRS)
            state.claimed =
                addresses->num_log_addrs == 1 && addresses->log_addr_type[0] == CEC_LOG_ADDR_TYPE_PLAYBACK;
        if (request == CEC_ADAP_G_LOG_ADDRS && !state.claimed)
            *addresses = {};
        if ((request == CEC_ADAP_G_LOG_ADDRS && state.claimed) || request == CEC_ADAP_S_LOG_ADDRS) {
            addresses->num_log_addrs = 1;
            addresses->log_addr[0] = 4;
            addresses->log_addr_mask = 1 << 4;
        }
        if (request == CEC_ADAP_G_PHYS_ADDR)
            *static_cast<__u16*>(argument) = 0x2100;
        return 0;
    }
};

TEST(Cec, PutsTheSetToSleepAndWakesItWithThisMachineShown) {
    FakeCec::State fake;
    Cec cec(std::make_unique<FakeCec>(fake));
    EXPECT_TRUE(cec.standby());
    EXPECT_TRUE(cec.wake());
    EXPECT_TRUE(fake.claimed);
    // From 4 to the set (0): <Standby>, <Image View On>; to all (15): <Active Source> with the physical
    // address.
    EXPECT_EQ(fake.sent, (std::vector<Bytes>{{0x40, 0x36}, {0x40, 0x04}, {0x4F, 0x82, 0x21, 0x00}}));
}

TEST(Cec, TellsAMissingSetFromABrokenOne) {
    for (const auto& [error, code] :
         {std::pair(-ENONET, "cec.no-screen"), {-ENETDOWN, "cec.no-screen"}, {-EIO, "cec.driver"}}) {
        FakeCec::State fake;
        fake.errors[CEC_TRANSMIT] = error;
        Cec cec(std::make_unique<FakeCec>(fake));
        EXPECT_EQ(cec.standby().error().code, code);
        EXPECT_EQ(cec.wake().error().code, code);
    }
    for (const unsigned long request : {CEC_ADAP_G_LOG_ADDRS, CEC_ADAP_S_LOG_ADDRS}) {
        FakeCec::State fake;
        fake.errors[request] = -EBUSY;
        EXPECT_EQ(Cec(std::make_unique<FakeCec>(fake)).standby().error().code, "cec.driver");
        EXPECT_TRUE(fake.sent.empty());
    }
    EXPECT_EQ(Cec::open("/dev/no-such-cec").error().code, "cec.missing");
}

} // namespace
} // namespace franken::platform
