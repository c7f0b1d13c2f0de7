// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw_scene.h"

namespace franken::test {

/// Pictures of 64 x 64 pixels of what a renderer shows, by a camera 3 m in front of the origin.
class ModelFixture : public PictureTest {
protected:
    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}; }

    Picture drawn(Renderer& renderer) {
        Camera camera;
        camera.world[3] = glm::vec4(0, 0, 3, 1);
        const Result<void> result = renderer.draw(viewpointOf(camera, 1), target());
        EXPECT_TRUE(result) << toString(result.error());
        return readBack();
    }
};

} // namespace franken::test
