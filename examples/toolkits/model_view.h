// SPDX-License-Identifier: MIT
#pragma once

#include "franken/orbit_camera.h"
#include "franken/renderer.h"

#include <filesystem>
#include <memory>

/// A model that is seen from all around, in a context that a toolkit draws with as well. Every function that
/// needs the context leaves GL's state as it was. Use it, and destroy it, with the context current.
class ModelView {
public:
    /// Reads a glTF file and uploads it. Fails as loadGltf() and Renderer::load() do.
    static franken::Result<std::unique_ptr<ModelView>> open(const franken::GetProcAddress& getProcAddress,
                                                            const std::filesystem::path& file);

    /// Fails as Renderer::draw() does.
    franken::Result<void> draw(const franken::DrawTarget& target);

    /// As OrbitCamera::drag().
    void drag(double x, double y) { static_cast<void>(m_camera.drag(x, y)); }

    static constexpr float kBrightest = 10; ///< Lux.
    float sun() const { return m_sun; }     ///< Lux.
    void setSun(float illuminance);

private:
    ModelView(const franken::Gl& gl, const franken::Scene& scene);

    franken::Renderer m_renderer;
    franken::Box m_bounds;
    franken::OrbitCamera m_camera;
    float m_sun = 0;
};
