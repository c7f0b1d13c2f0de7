// SPDX-License-Identifier: MIT
#include "kiosk/show/player.h"

#include <gtest/gtest.h>

namespace franken::test {
namespace {

using kiosk::Player;

/// Two nodes; each animation moves one of them to x = `height` and back, once in so many seconds.
struct Hop {
    int node;
    float seconds, height;
};

Scene sceneOf(const std::vector<Hop>& hops) {
    Scene scene;
    scene.nodes.resize(2);
    for (const auto& [node, seconds, height] : hops) {
        Animation animation{.duration = seconds};
        animation.samplers = {
            {.times = {0, seconds / 2, seconds}, .values = {0, 0, 0, height, 0, 0, 0, 0, 0}}};
        animation.channels = {{.sampler = 0, .node = node}};
        scene.animations.push_back(animation);
    }
    return scene;
}

double xOf(const Player& player, std::size_t node) {
    return player.pose().nodes.at(node).local.translation.x;
}

TEST(KioskPlayer, OneAnimationGoesRound) {
    const Scene scene = sceneOf({{0, 2, 8}});
    Player player;
    player.advance(scene, 0);
    EXPECT_EQ(xOf(player, 0), 0);
    for (int step = 0; step < 1000; ++step)
        player.advance(scene, 0.25);
    EXPECT_NEAR(xOf(player, 0), 0, 1e-9) << "250 s are 125 rounds";
    player.advance(scene, 0.5);
    EXPECT_NEAR(xOf(player, 0), 4, 1e-9);
    player.advance(scene, 0);
    EXPECT_NEAR(xOf(player, 0), 4, 1e-9) << "paused";
    player.advance(scene, 20.25);
    EXPECT_NEAR(xOf(player, 0), 6, 1e-9) << "in one step";
}

// The first lasts two rounds, 6 s, the second one, 5 s.
TEST(KioskPlayer, SeveralFollowEachOtherAndFade) {
    const Scene scene = sceneOf({{0, 3, 6}, {1, 5, 10}});
    Player player;
    const auto advance = [&](double seconds) { // As frames do.
        for (int part = 0; part < 10; ++part)
            player.advance(scene, seconds / 10);
    };
    advance(4.5);
    EXPECT_NEAR(xOf(player, 0), 6, 1e-6) << "in its second round";
    EXPECT_EQ(xOf(player, 1), 0);
    advance(1.25);
    EXPECT_NEAR(xOf(player, 0), 1 * 0.5, 1e-6) << "half faded, a quarter of a second before its end";
    EXPECT_NEAR(xOf(player, 1), 1 * 0.5, 1e-6) << "of 10 in 2.5 s, a quarter of a second after its begin";
    advance(0.75);
    EXPECT_EQ(xOf(player, 0), 0) << "it rests";
    EXPECT_NEAR(xOf(player, 1), 4, 1e-6) << "1 s after its begin";
    advance(3.75);
    EXPECT_NEAR(xOf(player, 0), 1 * 0.5, 1e-6) << "the first again";
    EXPECT_NEAR(xOf(player, 1), 1 * 0.5, 1e-6);
    Player other;
    other.advance(scene, 10.25 + 3 * (5.5 + 4.5));
    EXPECT_NEAR(xOf(other, 0), 1 * 0.5, 1e-6) << "in one step, three times round";
    EXPECT_NEAR(xOf(other, 1), 1 * 0.5, 1e-6);
}

TEST(KioskPlayer, AnAnimationOfNoDurationStaysAWhile) {
    const Scene scene = sceneOf({{0, 0, 0}, {1, 4, 8}});
    Player player;
    for (int step = 0; step < 38; ++step)
        player.advance(scene, 0.1);
    EXPECT_GT(xOf(player, 1), 0) << "it fades in after 3.5 s";
    for (int step = 0; step < 16; ++step)
        player.advance(scene, 0.1);
    EXPECT_NEAR(xOf(player, 1), 8 * 1.9 / 2, 1e-6);
}

} // namespace
} // namespace franken::test
