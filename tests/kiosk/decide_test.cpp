// SPDX-License-Identifier: MIT
#include "kiosk/control/gestures.h"
#include "kiosk/decide/frame_times.h"
#include "kiosk/decide/opening.h"
#include "kiosk/decide/relief.h"
#include "kiosk/decide/wander.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <sys/timex.h>

namespace franken::test {
namespace {

using namespace kiosk;
using namespace std::chrono_literals;

/// A day of July 2026; the 6th is a Monday.
std::tm at(int day, int hour, int minute, int second = 0) {
    std::tm time{};
    time.tm_year = 126;
    time.tm_mon = 6;
    time.tm_mday = day;
    time.tm_hour = hour;
    time.tm_min = minute;
    time.tm_sec = second;
    mktime(&time);
    return time;
}

Config shop() {
    Config config;
    config.hours[0] = {"09:00-12:30", "14:00-24:00"};
    config.hours[6] = {"00:00-02:00"};
    config.timetable.closed = {"2026-07-13", "12-25"};
    config.timetable.restart = "04:30";
    return config;
}

TEST(KioskTimetable, OpensAndClosesAtItsMinutes) {
    const Timetable timetable(shop());
    EXPECT_FALSE(timetable.isOpen(at(6, 8, 59, 59)));
    EXPECT_TRUE(timetable.isOpen(at(6, 9, 0)));
    EXPECT_FALSE(timetable.isOpen(at(6, 12, 30)));
    EXPECT_TRUE(timetable.isOpen(at(6, 23, 59, 59)));
    EXPECT_FALSE(timetable.isOpen(at(7, 0, 0))) << "Tuesday has no hours";
    EXPECT_TRUE(timetable.isOpen(at(5, 1, 0))) << "Sunday";
    EXPECT_FALSE(timetable.isOpen(at(13, 10, 0))) << "a closed Monday";
    EXPECT_TRUE(timetable.isOpen(at(20, 10, 0)));
}

TEST(KioskTimetable, WithoutHoursItIsAlwaysOpenButOnClosedDays) {
    Config config;
    EXPECT_TRUE(Timetable(config).isOpen(at(6, 3, 0)));
    config.timetable.closed = {"07-06"};
    EXPECT_FALSE(Timetable(config).isOpen(at(6, 3, 0)));
}

TEST(KioskTimetable, TellsWhenToLookAgainAndWhenToRestart) {
    const Timetable timetable(shop());
    EXPECT_EQ(timetable.secondsToLook(at(6, 8, 59, 30)), 30);
    EXPECT_TRUE(timetable.isRestartDue(at(6, 4, 30, 59)));
    EXPECT_FALSE(timetable.isRestartDue(at(6, 4, 31)));
    EXPECT_FALSE(Timetable(Config()).isRestartDue(at(6, 0, 0)));
}

TEST(KioskClock, AnAnswerThatFailedIsNoSynchronisedClock) {
    EXPECT_TRUE(isKernelSynchronised(TIME_OK, STA_PLL));
    EXPECT_FALSE(isKernelSynchronised(TIME_ERROR, STA_PLL));
    EXPECT_FALSE(isKernelSynchronised(TIME_OK, STA_UNSYNC));
    EXPECT_FALSE(isKernelSynchronised(-1, 0)) << "a sandbox refuses the call";
}

TEST(KioskPresence, SomebodyIsThereForTheIdleTimeAndWhileThereIsMotion) {
    Presence presence;
    EXPECT_TRUE(presence.isThere(24h)) << "without an idle time always";
    presence.setIdleTime(60s);
    presence.seen(100s);
    EXPECT_TRUE(presence.isThere(159s));
    EXPECT_EQ(presence.end(), Time(160s));
    EXPECT_FALSE(presence.isThere(160s));
    presence.setMotion(true, 200s);
    EXPECT_TRUE(presence.isThere(10000s));
    presence.setMotion(false, 10000s);
    EXPECT_FALSE(presence.isThere(10060s));
}

TEST(KioskOpening, HeedsTheTimetableOnlyWithAClockThatIsRight) {
    Opening opening;
    opening.configure(shop());
    EXPECT_EQ(opening.darkBecause(0s, at(6, 3, 0), false), "");
    EXPECT_EQ(opening.darkBecause(0s, at(6, 3, 0), true), "closed");
    EXPECT_FALSE(opening.isRestartDue(at(6, 4, 30), false));
    EXPECT_EQ(opening.nextLook(5s, at(6, 3, 0, 20)), Time(45s));
}

class KioskRelief : public testing::Test {
protected:
    /// Observes every two seconds.
    void pass(Time time, const Strain& strain) {
        for (const Time end = m_now + time; m_now < end; m_now += 2s)
            m_relief.observe(strain, m_now);
    }
    static Strain heat(double celsius) { return {.celsius = celsius, .throttled = {}, .freeMebibytes = {}}; }
    Relief m_relief;
    Time m_now{1h};
};

TEST_F(KioskRelief, GivesWayStepByStepAndComesBack) {
    pass(60s, heat(50));
    EXPECT_EQ(m_relief.step(), 0);
    pass(8s, heat(85));
    EXPECT_EQ(m_relief.step(), 0) << "a peak is no strain";
    pass(4s, heat(85));
    EXPECT_EQ(m_relief.step(), 1);
    EXPECT_EQ(m_relief.resolution(), 0.75);
    pass(10min, heat(85));
    EXPECT_EQ(m_relief.step(), Relief::kMostSteps);
    EXPECT_EQ(m_relief.frameRate(), 0.25);
    pass(1h, heat(77));
    EXPECT_EQ(m_relief.step(), Relief::kMostSteps) << "neither hot nor cool";
    pass(124s, heat(60));
    EXPECT_EQ(m_relief.step(), Relief::kMostSteps - 1);
    pass(10min, heat(60));
    EXPECT_EQ(m_relief.step(), 0);
    EXPECT_EQ(m_relief.resolution(), 1);
}

TEST_F(KioskRelief, ThrottlingCountsAndMemoryIsTheLoadersMatter) {
    pass(20s, {.celsius = {}, .throttled = true, .freeMebibytes = 8});
    EXPECT_GE(m_relief.step(), 1);
    EXPECT_FALSE(m_relief.mayPreload());
    EXPECT_NE(m_relief.reason().find("throttles"), std::string::npos) << m_relief.reason();
    pass(124s, {.celsius = {}, .throttled = false, .freeMebibytes = 64});
    EXPECT_TRUE(m_relief.mayPreload());
}

TEST_F(KioskRelief, MemoryThatTheNextModelWouldTakeAgainIsNotEnough) {
    const auto memory = [](double free) {
        return Strain{.celsius = {}, .throttled = {}, .freeMebibytes = free};
    };
    pass(2s, memory(15));
    EXPECT_FALSE(m_relief.mayPreload());
    pass(1h, memory(31));
    EXPECT_FALSE(m_relief.mayPreload()) << "less than twice what is too little";
    int changes = 0;
    for (int second = 0; second < 3600; second += 2) // A model of 50 MiB: free without it, taken with it.
        changes += m_relief.observe(memory(m_relief.mayPreload() ? 10 : 60), m_now += 2s) ? 1 : 0;
    EXPECT_LE(changes, 60) << "each minute at most";
    pass(124s, memory(60));
    EXPECT_TRUE(m_relief.mayPreload());
}

TEST(KioskWander, WalksRoundASquareAndComesBack) {
    EXPECT_EQ(wander(17min, 0), (Shift{0, 0}));
    Shift last = wander(0s, 4);
    for (int minute = 1; minute <= 64; ++minute) {
        const Shift shift = wander(std::chrono::minutes(minute), 4);
        EXPECT_EQ(std::abs(shift.x - last.x) + std::abs(shift.y - last.y), 1) << minute;
        EXPECT_EQ(std::max(std::abs(shift.x), std::abs(shift.y)), 4);
        last = shift;
    }
    EXPECT_EQ(last, wander(0s, 4));
    for (const Time time : {Time(0s), Time(59s), Time(60s), Time(90min + 7ms)}) {
        EXPECT_EQ(wander(nextWander(time) - 1ns, 4), wander(time, 4));
        EXPECT_FALSE(wander(nextWander(time), 4) == wander(time, 4));
    }
}

TEST(KioskFrameTimes, PercentilesAreOfTheLastFrames) {
    FrameTimes times;
    EXPECT_FALSE(times.percentile(50));
    for (int i = 1; i <= 100; ++i)
        times.add(std::chrono::milliseconds(i), i % 10 == 0 ? 2 : 0);
    EXPECT_NEAR(*times.percentile(50), 0.050, 1e-9);
    EXPECT_NEAR(*times.percentile(95), 0.095, 1e-9);
    EXPECT_NEAR(*times.percentile(100), 0.100, 1e-9);
    EXPECT_EQ(times.late(), 10U);
    for (std::size_t i = 0; i < FrameTimes::kWindow; ++i)
        times.add(7ms, 0);
    EXPECT_NEAR(*times.percentile(99), 0.007, 1e-9);
    EXPECT_EQ(times.frames(), 700U);
}

class KioskGestures : public testing::Test {
protected:
    using Kind = platform::TouchEvent::Kind;
    void touch(Kind kind, int finger, double x, double y, std::chrono::milliseconds time) {
        const Gestures::Moves moves = m_gestures.take({kind, finger, {x, y}, time});
        m_sum.dragX += moves.dragX;
        m_sum.dragY += moves.dragY;
        m_sum.zoom *= moves.zoom;
        m_sum.names.insert(m_sum.names.end(), moves.names.begin(), moves.names.end());
    }
    void tap(std::chrono::milliseconds time) {
        touch(Kind::Down, 0, 0.5, 0.5, time);
        touch(Kind::Up, 0, 0.5, 0.5, time + 80ms);
    }
    /// Two fingers, from where to where.
    void pair(double ax, double bx, double toAx, double toBx, double dy = 0) {
        touch(Kind::Down, 0, ax, 0.5, 0ms);
        touch(Kind::Down, 1, bx, 0.5, 10ms);
        for (int i = 1; i <= 10; ++i) {
            touch(Kind::Move, 0, ax + (toAx - ax) * i / 10, 0.5 + dy * i / 10, 20ms * i);
            touch(Kind::Move, 1, bx + (toBx - bx) * i / 10, 0.5 + dy * i / 10, 20ms * i);
        }
        touch(Kind::Up, 0, toAx, 0.5, 300ms);
        touch(Kind::Up, 1, toBx, 0.5, 310ms);
    }
    Gestures m_gestures;
    Gestures::Moves m_sum;
};

using Names = std::vector<std::string>;

TEST_F(KioskGestures, OneFingerTurnsAndTaps) {
    touch(Kind::Down, 0, 0.2, 0.5, 0ms);
    touch(Kind::Move, 0, 0.5, 0.4, 100ms);
    touch(Kind::Up, 0, 0.5, 0.4, 120ms);
    EXPECT_NEAR(m_sum.dragX, 0.3, 1e-9);
    EXPECT_NEAR(m_sum.dragY, -0.1, 1e-9);
    EXPECT_TRUE(m_sum.names.empty());
    tap(1000ms);
    tap(1300ms);
    tap(3000ms);
    EXPECT_EQ(m_sum.names, (Names{"tap", "double-tap", "tap"}));
}

TEST_F(KioskGestures, TwoFingersThatPartComeNearer) {
    pair(0.45, 0.55, 0.3, 0.7);
    EXPECT_NEAR(m_sum.zoom, 0.25, 1e-9);
    EXPECT_EQ(m_sum.dragX, 0);
    EXPECT_TRUE(m_sum.names.empty());
}

TEST_F(KioskGestures, TwoFingersThatGoTheSameWaySwipe) {
    pair(0.6, 0.8, 0.2, 0.4);
    pair(0.2, 0.4, 0.6, 0.8);
    pair(0.4, 0.6, 0.4, 0.6, -0.3);
    EXPECT_EQ(m_sum.names, (Names{"swipe-left", "swipe-right", "swipe-up"}));
    EXPECT_NEAR(m_sum.zoom, 1, 0.01);
}

TEST_F(KioskGestures, ACancelledTouchDoesNothing) {
    touch(Kind::Down, 0, 0.5, 0.5, 0ms);
    touch(Kind::Cancel, 0, 0.5, 0.5, 50ms);
    EXPECT_TRUE(m_sum.names.empty());
}

} // namespace
} // namespace franken::test
