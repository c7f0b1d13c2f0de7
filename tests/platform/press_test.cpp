// SPDX-License-Identifier: MIT
#include "franken/platform/press.h"

#include <gtest/gtest.h>

#include <string>

namespace franken::platform {
namespace {

using namespace std::chrono_literals;
using Events = std::vector<PressRecogniser::Event>;

std::string names(const Events& events) {
    std::string text;
    for (const PressRecogniser::Event& event : events)
        text.append(text.empty() ? "" : " ").append(toString(event.press));
    return text;
}

TEST(Debouncer, TakesABurstForOneChangeAtItsFirstEdge) {
    Debouncer debouncer(false, 10ms);
    for (const auto& [active, time] : {std::pair(true, 100ms), {false, 103ms}, {true, 107ms}})
        EXPECT_FALSE(debouncer.edge({active, time}));
    const std::optional<ContactEdge> change = debouncer.settled(true);
    ASSERT_TRUE(change);
    EXPECT_TRUE(change->active);
    EXPECT_EQ(change->time, 100ms);
    EXPECT_FALSE(debouncer.settled(true)) << "told twice";
}

TEST(Debouncer, IgnoresASpike) {
    Debouncer debouncer(false, 10ms);
    EXPECT_FALSE(debouncer.edge({true, 100ms}));
    EXPECT_FALSE(debouncer.edge({false, 101ms}));
    EXPECT_FALSE(debouncer.settled(false));
}

TEST(Debouncer, LosesNoPressThatIsReadLate) {
    Debouncer debouncer(false, 10ms);
    EXPECT_FALSE(debouncer.edge({true, 100ms}));
    const std::optional<ContactEdge> pressed = debouncer.edge({false, 150ms});
    ASSERT_TRUE(pressed);
    EXPECT_EQ(pressed->time, 100ms);
    EXPECT_EQ(debouncer.settled(false)->time, 150ms);
}

TEST(Debouncer, BelievesTheLevelWhereEdgesWereLost) {
    Debouncer debouncer(false, 10ms);
    EXPECT_FALSE(debouncer.edge({false, 100ms}));
    EXPECT_TRUE(debouncer.settled(true));
}

TEST(PressRecogniser, TellsShortFromLong) {
    PressRecogniser button({.longPress = 800ms});
    Events events;
    button.edge({true, 0ms}, events);
    button.edge({false, 799ms}, events);
    EXPECT_EQ(names(events), "down short");
    button.edge({true, 2s}, events);
    EXPECT_EQ(button.patience(), 800ms);
    button.expired(events);
    button.edge({false, 3s}, events);
    EXPECT_EQ(names(events), "down short down long");
}

TEST(PressRecogniser, TellsLongFromItsStampsWhereTheTimerWasLate) {
    PressRecogniser button({.longPress = 800ms});
    Events events;
    button.edge({true, 0ms}, events);
    button.edge({false, 900ms}, events);
    EXPECT_EQ(names(events), "down long");
    EXPECT_EQ(events[1].time, 800ms);
}

TEST(PressRecogniser, TellsTwoPressesFromADoubleOne) {
    PressRecogniser button({.doublePress = 300ms});
    Events events;
    for (const auto& [active, time] : {std::pair(true, 0ms), {false, 50ms}, {true, 200ms}, {false, 250ms}})
        button.edge({active, time}, events);
    EXPECT_EQ(names(events), "down down double");
    EXPECT_FALSE(button.patience());
    events.clear();
    for (const auto& [active, time] :
         {std::pair(true, 1000ms), {false, 1050ms}, {true, 1400ms}, {false, 1450ms}})
        button.edge({active, time}, events);
    button.expired(events);
    EXPECT_EQ(names(events), "down short down short");
}

struct Turn {
    bool isB, active;
};

int turn(EncoderDecoder& encoder, std::initializer_list<Turn> turns) {
    int steps = 0;
    for (const Turn& edge : turns)
        steps += encoder.edge(edge.isB, edge.active);
    return steps;
}

TEST(EncoderDecoder, CountsStepsBothWaysAndNoBounce) {
    EncoderDecoder encoder(false, false, 4);
    EXPECT_EQ(turn(encoder, {{false, true}, {true, true}, {false, false}, {true, false}}), 1);
    EXPECT_EQ(turn(encoder, {{true, true}, {false, true}, {true, false}, {false, false}}), -1);
    EXPECT_EQ(turn(encoder, {{false, true}, {false, false}, {false, true}, {false, false}}), 0);
}

} // namespace
} // namespace franken::platform
