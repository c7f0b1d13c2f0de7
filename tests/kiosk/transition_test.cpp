// SPDX-License-Identifier: MIT
#include "kiosk/show/transition.h"

#include <gtest/gtest.h>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using kiosk::Transition;

class KioskTransition : public testing::Test {
protected:
    KioskTransition() { m_transition.configure(1s, 10s); }
    Transition m_transition;
};

TEST_F(KioskTransition, FadesInAsSoonAsTheFirstModelIsReady) {
    EXPECT_FALSE(m_transition.advance(0s, false));
    EXPECT_EQ(m_transition.cover(0s), 1);
    EXPECT_TRUE(m_transition.advance(1s, true));
    EXPECT_EQ(m_transition.cover(1s), 1);
    EXPECT_EQ(m_transition.cover(1500ms), 0.5);
    EXPECT_FALSE(m_transition.advance(2s, false));
    EXPECT_EQ(m_transition.cover(2s), 0);
}

TEST_F(KioskTransition, ChangesThroughTheBackgroundOnceTheNextIsReady) {
    m_transition.advance(0s, true);
    m_transition.advance(1s, false);
    EXPECT_FALSE(m_transition.advance(11s, false));
    EXPECT_EQ(m_transition.cover(11s), 0) << "it waits for the next model with the picture on";
    EXPECT_FALSE(m_transition.advance(12s, true));
    EXPECT_EQ(m_transition.cover(12750ms), 0.75);
    EXPECT_TRUE(m_transition.advance(13s, true));
    EXPECT_EQ(m_transition.cover(13s), 1);
}

TEST_F(KioskTransition, WithoutANextOneAModelStays) {
    m_transition.advance(0s, true);
    m_transition.advance(1s, false);
    for (int second = 2; second < 100; ++second) {
        EXPECT_FALSE(m_transition.advance(std::chrono::seconds(second), false));
        EXPECT_EQ(m_transition.cover(std::chrono::seconds(second)), 0);
    }
}

TEST_F(KioskTransition, AModelThatWasTakenAwayGoesWithoutANextOne) {
    m_transition.leave();
    EXPECT_FALSE(m_transition.leaves()) << "nothing is shown";
    m_transition.advance(0s, true);
    m_transition.advance(1s, false);
    m_transition.leave();
    EXPECT_FALSE(m_transition.advance(5s, false));
    EXPECT_EQ(m_transition.cover(5500ms), 0.5);
    EXPECT_FALSE(m_transition.advance(6s, false));
    EXPECT_EQ(m_transition.phase(), Transition::Phase::Empty);
    EXPECT_EQ(m_transition.cover(6s), 1);
    EXPECT_TRUE(m_transition.advance(7s, true)) << "another one came";
    EXPECT_FALSE(m_transition.advance(9s, true));
    m_transition.leave();
    m_transition.advance(10s, false);
    EXPECT_TRUE(m_transition.advance(11s, true)) << "one came during the fade";
    EXPECT_FALSE(m_transition.leaves());
}

TEST_F(KioskTransition, SomebodyCanAskForTheNext) {
    m_transition.configure(0s, 0s);
    EXPECT_TRUE(m_transition.advance(0s, true));
    EXPECT_FALSE(m_transition.advance(3600s, true));
    m_transition.next();
    EXPECT_FALSE(m_transition.advance(3601s, false));
    EXPECT_TRUE(m_transition.advance(3602s, true));
}

} // namespace
} // namespace franken::test
