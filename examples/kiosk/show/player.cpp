// SPDX-License-Identifier: MIT
#include "kiosk/show/player.h"

#include <algorithm>
#include <cmath>

namespace kiosk {

namespace {

double durationOf(const franken::Scene& scene, int animation) {
    return scene.animations[static_cast<std::size_t>(animation)].duration;
}

/// How long it plays: whole rounds, if it has a duration.
double spanOf(const franken::Scene& scene, int animation) {
    const double round = durationOf(scene, animation);
    return round > 0 ? round * std::max(std::ceil(Player::kLeastSeconds / round), 1.0)
                     : Player::kLeastSeconds;
}

} // namespace

void Player::advance(const franken::Scene& scene, double seconds) {
    const int count = static_cast<int>(scene.animations.size());
    if (m_rest.nodes.empty())
        m_rest = franken::restPose(scene);
    // What an animation does not move rests: of the one before, nothing is left.
    const auto pose = [&](int animation, double time, franken::Pose& out) {
        out = m_rest;
        [[maybe_unused]] const auto sampled =
            franken::sample(scene, animation, time, out, franken::Ends::Loop);
    };
    m_time += seconds;
    if (count == 1) {
        if (const double round = durationOf(scene, 0); round > 0)
            m_time = std::fmod(m_time, round);
        return pose(0, m_time, m_pose);
    }
    for (double span = spanOf(scene, m_animation); m_time >= span; span = spanOf(scene, m_animation)) {
        m_time -= span - kFadeSeconds;
        m_animation = (m_animation + 1) % count;
    }
    pose(m_animation, m_time, m_pose);
    const double fading = m_time - (spanOf(scene, m_animation) - kFadeSeconds);
    if (fading <= 0)
        return;
    pose((m_animation + 1) % count, fading, m_next);
    [[maybe_unused]] const auto mixed = franken::mix(m_pose, m_next, fading / kFadeSeconds, m_pose);
}

} // namespace kiosk
