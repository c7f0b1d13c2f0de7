// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/generator/snippet_set.h"
#include "franken/renderer.h"
#include "measure.h"
#include "options.h"

#include <memory>
#include <optional>
#include <span>

/// Everything that a picture shows.
struct Subject {
    franken::Scene scene;
    franken::Camera camera;
    franken::Lighting lighting;
    std::shared_ptr<const franken::BakedSky> sky; ///< Null for none.
};

/// The programs that a picture needs and the states that it draws them in, the skybox included.
franken::Result<std::vector<franken::ProgramUse>> usesOf(const Subject& subject, const franken::Look& look,
                                                         const franken::Log& log);

/// Its camera, with clipping planes that suit the scene.
franken::Viewpoint viewpointOf(const Subject& subject, double aspect);

/// A picture, and what it took.
struct Drawn {
    franken::Image picture;                  ///< Row 0 at the top.
    std::vector<franken::ProgramUse> needed; ///< For a manifest.
    franken::WarmUpReport warmUp;
    franken::ProgramCounters before, warm, after; ///< The warm-up, after it, after the frame.
    franken::FrameCounters frame;
    std::size_t gpuBytes = 0; ///< Of textures and meshes.
};

/// The effect of a set that has one at most.
franken::EffectChoice effectOf(const std::optional<franken::SnippetSet>& snippets);

/// A context and a renderer that stay from picture to picture, and with them all programs.
class Studio {
public:
    /// The options must outlive it. Fails as platform::create() and Gl::load() do.
    static franken::Result<std::unique_ptr<Studio>> open(const Options& options, const franken::Log& log);

    /// Makes and draws with all programs that the picture needs and those of the list, then draws it. With
    /// snippets of the user's own, each program must compile: the error says where it does not, no simpler
    /// program stands in, and the snippets of the picture before are kept.
    franken::Result<Drawn> draw(const Subject& subject, std::span<const franken::ProgramUse> listed,
                                const std::optional<franken::SnippetSet>& snippets);

    /// The picture of what was drawn last, from another camera.
    franken::Result<franken::Image> drawAgain(const Subject& subject);

    /// Times the picture of what was drawn last. Fails with "viewer.measure" where software draws.
    franken::Result<Measured> measure(const Subject& subject);

    /// That of the options, as the context takes it.
    franken::Look look(const std::optional<franken::SnippetSet>& snippets) const;
    franken::DrawTarget target() const;

private:
    Studio(const Options& options, std::unique_ptr<franken::platform::Surface> surface, const franken::Gl& gl,
           const franken::Log& log)
        : m_options(options), m_surface(std::move(surface)), m_gl(gl), m_renderer(gl, log) {}

    franken::Result<void> useSnippets(const franken::SnippetSet& snippets,
                                      std::span<const franken::ProgramUse> needed);
    franken::Result<void> show(const Subject& subject);
    franken::Result<franken::WarmUpReport> warmUp(const franken::DrawTarget& target,
                                                  std::span<const franken::ProgramUse> needed,
                                                  std::span<const franken::ProgramUse> listed);

    const Options& m_options;
    std::unique_ptr<franken::platform::Surface> m_surface;
    franken::Gl m_gl;
    franken::Renderer m_renderer;
    std::shared_ptr<const franken::BakedSky> m_sky; ///< That the renderer has.
};
