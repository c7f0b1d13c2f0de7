// SPDX-License-Identifier: MIT
#include "model_view.h"

#include "franken/gltf.h"

#include <algorithm>

using namespace franken;

Result<std::unique_ptr<ModelView>> ModelView::open(const GetProcAddress& getProcAddress,
                                                   const std::filesystem::path& file) {
    const Result<Gl> gl = Gl::load(getProcAddress);
    if (!gl)
        return gl.error();
    const Result<Scene> scene = loadGltf(file);
    if (!scene)
        return scene.error();
    std::unique_ptr<ModelView> view(new ModelView(*gl, *scene));
    Renderer& renderer = view->m_renderer;
    const Result<void> loaded = renderer.acquireState().and_then([&] { return renderer.load(*scene); });
    const Result<void> released = renderer.releaseState();
    if (!loaded || !released)
        return loaded ? released.error() : loaded.error();
    return view;
}

ModelView::ModelView(const Gl& gl, const Scene& scene)
    : m_renderer(gl), m_bounds(scene.bounds()), m_camera(framingCamera(m_bounds, 1), m_bounds) {
    setSun(3);
}

void ModelView::setSun(float illuminance) {
    m_sun = std::clamp(illuminance, 0.0f, kBrightest);
    m_renderer.setLighting({.suns = {{.direction = {-1, -2, -3}, .illuminance = m_sun}},
                            .ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.3f}}});
}

Result<void> ModelView::draw(const DrawTarget& target) {
    if (Result<void> acquired = m_renderer.acquireState(); !acquired)
        return acquired;
    static_cast<void>(m_camera.advance(0));
    const Camera camera = tightened(m_camera.camera(), m_bounds);
    const Result<void> drawn = m_renderer.draw(viewpointOf(camera, aspectOf(target)), target);
    const Result<void> released = m_renderer.releaseState(); // Even where nothing was drawn.
    return drawn ? released : drawn;
}
