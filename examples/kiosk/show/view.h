// SPDX-License-Identifier: MIT
#pragma once

#include "franken/orbit_camera.h"
#include "franken/scene.h"
#include "kiosk/config/config.h"
#include "kiosk/show/player.h"

#include <optional>

namespace kiosk {

/// Where one looks at a model from: round it, or through one of its file's cameras; and the pose that its
/// animations give it.
class View {
public:
    /// `still`: the scene; its meshes and images are not needed. `bounds`: what it
    /// passes through as it turns. `aspect`: width over height.
    View(franken::Scene still, const franken::Box& bounds, double aspect, const Config& config);

    void configure(const Config& config);
    void setAspect(double aspect);

    /// Goes on by so many seconds.
    void advance(double seconds);
    /// Whether advance() changes the picture.
    bool moves() const;

    franken::Camera camera() const;
    /// Nothing without an animation.
    const franken::Pose* pose() const { return m_isPosed ? &m_player.pose() : nullptr; }
    const franken::Scene& still() const { return m_still; }
    const franken::Box& bounds() const { return m_bounds; }

    void setPaused(bool paused) { m_paused = paused; }
    void nextCamera();
    /// As fingers ask: parts of the picture's height, and a factor of the distance.
    void drag(double x, double y);
    void zoom(double factor);

private:
    bool playsAnimation() const { return m_animations && !m_still.animations.empty(); }

    franken::Scene m_still;
    franken::Box m_bounds;
    franken::OrbitCamera m_orbit;
    int m_camera = franken::kNone; ///< Of the file's; kNone: round the model.
    bool m_wantsFile = false;      ///< By the configuration: the file's cameras.
    double m_turnSeconds = 0;
    bool m_animations = true, m_paused = false, m_isPosed = false, m_settling = false;
    Player m_player;
};

} // namespace kiosk
