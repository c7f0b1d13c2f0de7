// SPDX-License-Identifier: MIT
#include "kiosk/decide/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using kiosk::Pace;
using kiosk::Time;

/// A screen that shows what is drawn at its next refresh, and who draws at a pace.
class Player {
public:
    Player(double most, int milliHertz) : m_period(1'000'000'000'000 / milliHertz) {
        m_pace.configure(most, milliHertz);
    }

    /// Draws a frame that takes so long, as soon as it may; returns how many refreshes it missed.
    std::int64_t draw(Time work) {
        now = m_pace.next(now);
        m_pace.begun(now);
        m_begun = now;
        const std::int64_t due = refreshAfter(now);
        const std::int64_t done = refreshAfter(now + work);
        now = done * m_period;
        m_pace.shown(now);
        now += 300us; // Until the loop hears of it.
        interval = done - m_last;
        m_last = done;
        return done - due;
    }
    Time begun() const { return m_begun; }

    Time now = 1h + 5ms;
    std::int64_t interval = 0; ///< Refreshes from the frame before to the last one.

private:
    std::int64_t refreshAfter(Time time) const { return time / m_period + 1; }

    Time m_period;
    Pace m_pace;
    Time m_begun{0};
    std::int64_t m_last = 0;
};

struct Schedule {
    double most;
    int milliHertz;
    std::int64_t refreshes; ///< From frame to frame.
};

class KioskPace : public testing::TestWithParam<Schedule> {};
INSTANTIATE_TEST_SUITE_P(
    , KioskPace,
    testing::Values(Schedule{60, 60'000, 1}, Schedule{60, 59'940, 1}, Schedule{30, 60'000, 2},
                    Schedule{30, 59'940, 2}, Schedule{25, 50'000, 2}, Schedule{24, 60'000, 3},
                    Schedule{20, 60'000, 3}, Schedule{20, 59'871, 3}, Schedule{15, 60'000, 4},
                    Schedule{60, 144'000, 3}, Schedule{1, 60'000, 60}),
    [](const auto& row) {
        return std::to_string(static_cast<int>(row.param.most)) + "of" + std::to_string(row.param.milliHertz);
    });

TEST_P(KioskPace, EachFrameHasMostOfARefreshAndNoneIsLate) {
    const auto [most, milliHertz, refreshes] = GetParam();
    const Time work = Time(1'000'000'000'000 / milliHertz) * 7 / 8;
    Player player(most, milliHertz);
    player.draw(1ms); // When refreshes are is not known before it.
    for (int frame = 0; frame < 5000; ++frame) {
        ASSERT_EQ(player.draw(frame % 3 == 0 ? work : 1us), 0) << frame;
        ASSERT_TRUE(player.interval == refreshes || frame == 0) << frame;
    }
}

TEST_P(KioskPace, AFrameThatTakesTwoRefreshesDelaysOnlyWhereNoneIsSpare) {
    const auto [most, milliHertz, refreshes] = GetParam();
    const Time work = Time(1'000'000'000'000 / milliHertz) * 3 / 2;
    Player player(most, milliHertz);
    player.draw(work);
    player.draw(work);
    for (int frame = 0; frame < 100; ++frame) {
        EXPECT_EQ(player.draw(work), 1);
        EXPECT_EQ(player.interval, std::max<std::int64_t>(refreshes, 2));
    }
}

TEST_P(KioskPace, AFrameAfterAStillPictureBeginsJustAfterARefresh) {
    const auto [most, milliHertz, refreshes] = GetParam();
    const Time period(1'000'000'000'000 / milliHertz);
    Player player(most, milliHertz);
    player.draw(1ms);
    for (int wait = 0; wait < 1000; ++wait) {
        player.now += period + wait * 977us % 900ms;
        const Time asked = player.now;
        EXPECT_EQ(player.draw(period * 7 / 8 - 1us), 0) << wait;
        const Time waited = player.begun() - asked;
        EXPECT_LE(waited, refreshes * period + period / 8) << wait;
    }
}

TEST(KioskPaceAlone, BeginsAtOnceWhereRefreshesAreNotKnownOrFramesAreShownAtOnce) {
    Pace pace;
    pace.configure(20, 60'000);
    EXPECT_EQ(pace.next(7s), Time(7s));
    pace.begun(7s);
    pace.shown(7s + 5ms);
    EXPECT_EQ(pace.next(3600s), Time(3600s)) << "the screen's clock is another one";
    pace.configure(20, 0);
    pace.begun(8s);
    EXPECT_EQ(pace.next(8s + 1ms), Time(8s + 50ms));
    pace.shown(8s + 2ms);
    EXPECT_EQ(pace.next(9s), Time(9s));
}

TEST(KioskPaceAlone, WhoComesTooLateIsNotSentAwayAgain) {
    Pace pace;
    pace.configure(20, 60'000);
    pace.shown(1s);
    pace.begun(1s + 1ms);
    pace.shown(1s + 16'666'666ns);
    const Time planned = pace.next(1s + 20ms);
    EXPECT_GT(planned, Time(1s + 50ms));
    EXPECT_LT(planned, Time(1s + 52ms));
    EXPECT_EQ(pace.next(planned + 12ms), planned + 12ms);
}

} // namespace
} // namespace franken::test
