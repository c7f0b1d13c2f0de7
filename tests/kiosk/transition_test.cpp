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
    EXPECT_FALSE(m_transition.advance(0s, false, false));
    EXPECT_EQ(m_transition.cover(0s), 1);
    EXPECT_TRUE(m_transition.advance(1s, true, false));
    EXPECT_EQ(m_transition.cover(1s), 1);
    EXPECT_EQ(m_transition.cover(1500ms), 0.5);
    EXPECT_FALSE(m_transition.advance(2s, false, false));
    EXPECT_EQ(m_transition.cover(2s), 0);
}

TEST_F(KioskTransition, ChangesThroughTheBackgroundOnceTheNextIsReady) {
    m_transition.advance(0s, true, false);
    m_transition.advance(1s, false, false);
    EXPECT_FALSE(m_transition.advance(11s, false, false));
    EXPECT_EQ(m_transition.cover(11s), 0) << "it waits for the next model with the picture on";
    EXPECT_FALSE(m_transition.advance(12s, true, false));
    EXPECT_EQ(m_transition.cover(12750ms), 0.75);
    EXPECT_TRUE(m_transition.advance(13s, true, false));
    EXPECT_EQ(m_transition.cover(13s), 1);
}

TEST_F(KioskTransition, AModelThatIsAloneStays) {
    m_transition.advance(0s, true, false);
    m_transition.advance(1s, false, true);
    for (int second = 2; second < 100; ++second) {
        EXPECT_FALSE(m_transition.advance(std::chrono::seconds(second), true, true));
        EXPECT_EQ(m_transition.cover(std::chrono::seconds(second)), 0);
    }
}

TEST_F(KioskTransition, SomebodyCanAskForTheNext) {
    m_transition.configure(0s, 0s);
    EXPECT_TRUE(m_transition.advance(0s, true, false));
    EXPECT_FALSE(m_transition.advance(3600s, true, false));
    m_transition.next();
    EXPECT_FALSE(m_transition.advance(3601s, false, false));
    EXPECT_TRUE(m_transition.advance(3602s, true, false));
}

} // namespace
} // namespace franken::test
