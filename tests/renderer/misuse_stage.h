// SPDX-License-Identifier: MIT
#pragma once
// What the tests of misuse draw, on drivers that draw nothing.
#include "franken/renderer.h"
#include "support/null_gl.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace franken::test {

inline constexpr DrawTarget kTarget{.width = 64, .height = 48};

inline Scene ball() {
    SceneBuilder builder;
    builder.add(sphere(6), builder.addMaterial(tiledMaterial(builder)));
    return builder.scene;
}

inline Lighting sunny(std::size_t suns = 1, std::size_t punctualLights = 0) {
    Lighting lighting;
    for (std::size_t i = 0; i < suns; ++i)
        lighting.suns.push_back(
            {.direction = {std::cos(float(i)), -1, std::sin(float(i))}, .illuminance = 1});
    for (std::size_t i = 0; i < punctualLights; ++i)
        lighting.punctualLights.push_back({.position = {double(i), 2, 0}, .intensity = float(i + 1)});
    return lighting;
}

inline Image white(int width, int height) {
    return {"white", width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height, 255)};
}

inline SkyboxMap whiteCube(int size) {
    SkyboxMap cube{.size = size, .range = 1, .images = {}};
    cube.images.fill(white(size, size));
    return cube;
}

/// A renderer that shows something, on a driver that does nothing.
struct Stage {
    Stage() : renderer(gl) {
        renderer.setLighting(sunny());
        EXPECT_TRUE(renderer.load(ball(), [] { return Result<Scene>(ball()); }));
        EXPECT_TRUE(draw());
    }
    Result<void> draw(const Viewpoint& viewpoint = {}, const DrawTarget& target = kTarget) {
        return renderer.draw(viewpoint, target);
    }
    Result<void> lit(const Lighting& lighting) {
        renderer.setLighting(lighting);
        return draw();
    }
    Result<void> overlay(const OverlayQuad& quad) { return renderer.drawOverlay({&quad, 1}, kTarget); }
    Result<void> overlay(OverlayRect place, Float4 color = {1, 1, 1, 1}) {
        const Result<PictureId> picture = renderer.addPicture(white(2, 2));
        return overlay(OverlayQuad{.picture = *picture, .place = place, .color = color});
    }

    Gl gl = nullGl();
    Renderer renderer;
};

} // namespace franken::test
