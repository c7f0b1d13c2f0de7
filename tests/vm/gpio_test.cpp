// SPDX-License-Identifier: MIT
//
// Buttons, an encoder and an output on gpio-sim. In virtual time.
#include "franken/platform/gpio.h"
#include "support/guest.h"
#include "support/sim_chip.h"

#include <poll.h>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using namespace platform;

/// Polls for so long and counts what comes.
GpioInputs::Events wait(GpioInputs& inputs, std::chrono::milliseconds time) {
    GpioInputs::Events all;
    const auto end = std::chrono::steady_clock::now() + time;
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left.count() <= 0)
            return all;
        pollfd ready = {inputs.descriptor(), POLLIN, 0};
        poll(&ready, 1, static_cast<int>(left.count()));
        const GpioInputs::Events some = inputs.dispatch();
        all.buttons.insert(all.buttons.end(), some.buttons.begin(), some.buttons.end());
        all.encoders.insert(all.encoders.end(), some.encoders.begin(), some.encoders.end());
    }
}

std::string names(const GpioInputs::Events& events) {
    std::string text;
    for (const ButtonEvent& event : events.buttons)
        text.append(text.empty() ? "" : " ").append(toString(event.press));
    return text;
}

class Gpio : public GuestTest {
protected:
    void SetUp() override {
        GuestTest::SetUp();
        if (!IsSkipped())
            chip.emplace();
    }
    static ButtonOptions button(unsigned line) { return {.name = "next", .pin = {.number = line}}; }
    std::optional<SimChip> chip;
};

TEST_F(Gpio, AThousandBouncingPressesAreAThousandEvents) {
    chip->pull(17, true);
    GpioInputs inputs({button(17)}, {}, Log());
    ASSERT_TRUE(inputs.complete());
    std::size_t edges = 0, shorts = 0, downs = 0;
    for (int press = 0; press < 1000; ++press) {
        for (const bool up : {false, true, false, /* released: */ true, false, true}) {
            chip->pull(17, up);
            ++edges;
            const GpioInputs::Events events = wait(inputs, edges % 3 == 0 ? 40ms : 2ms);
            for (const ButtonEvent& event : events.buttons)
                ++(event.press == Press::Down ? downs : shorts);
        }
    }
    EXPECT_GE(edges, 3000u);
    EXPECT_EQ(downs, 1000u);
    EXPECT_EQ(shorts, 1000u);
}

TEST_F(Gpio, TellsLongAndDoublePresses) {
    chip->pull(17, true);
    ButtonOptions options = button(17);
    options.press.doublePress = 300ms;
    GpioInputs inputs({options}, {}, Log());
    chip->pull(17, false);
    EXPECT_EQ(names(wait(inputs, 1s)), "down long");
    chip->pull(17, true);
    EXPECT_EQ(names(wait(inputs, 1s)), "");
    std::string all;
    for (const bool up : {false, true, false, true}) {
        chip->pull(17, up);
        const std::string some = names(wait(inputs, 60ms));
        all += some.empty() ? "" : some + ";";
    }
    EXPECT_EQ(all, "down;down double;");
}

TEST_F(Gpio, AnEncoderCountsItsSteps) {
    chip->pull(5, true);
    chip->pull(6, true);
    GpioInputs inputs({}, {{.name = "knob", .a = {.number = 5}, .b = {.number = 6}}}, Log());
    const auto turn = [&](std::initializer_list<std::pair<unsigned, bool>> edges) {
        int steps = 0;
        for (const auto& [line, up] : edges) {
            chip->pull(line, up);
            for (const EncoderEvent& event : wait(inputs, 5ms).encoders)
                steps += event.steps;
        }
        return steps;
    };
    EXPECT_EQ(turn({{5, false}, {6, false}, {5, true}, {6, true}}), 1);
    EXPECT_EQ(turn({{6, false}, {5, false}, {6, true}, {5, true}}), -1);
}

TEST_F(Gpio, AnOutputIsSetAndABusyLineIsToldOnce) {
    GpioOutput lamp({.number = 22}, false, true, Log());
    EXPECT_EQ(chip->value(22), "1");
    EXPECT_TRUE(lamp.set(false));
    EXPECT_EQ(chip->value(22), "0");
    std::vector<std::string> said;
    ButtonOptions options = button(22);
    GpioInputs inputs({options}, {}, [&](LogLevel, std::string_view text) { said.emplace_back(text); });
    wait(inputs, 5s);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("gpio.busy"), std::string::npos) << said[0];
}

TEST_F(Gpio, AChipThatGoesAndReturnsIsUsedAgain) {
    chip->pull(17, true);
    GpioInputs inputs({button(17)}, {}, Log());
    ASSERT_TRUE(inputs.complete());
    chip.reset();
    wait(inputs, 3s);
    EXPECT_FALSE(inputs.complete());
    chip.emplace();
    chip->pull(17, true);
    wait(inputs, 3s);
    ASSERT_TRUE(inputs.complete());
    chip->pull(17, false);
    EXPECT_EQ(names(wait(inputs, 50ms)), "down");
}

} // namespace
} // namespace franken::test
