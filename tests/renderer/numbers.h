// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw_scene.h"
#include "support/shapes.h"

#include <array>

namespace franken::test {

/// A scene whose square of 2 x 2 fills the picture, seen along -Z by parallel lines of sight. Codes are
/// linear: 255 is a radiance of 1.
inline Shot filledBy(const SceneBuilder& builder) {
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = {}};
    shot.camera.projection = Camera::Projection::Orthographic;
    shot.camera.xmag = shot.camera.ymag = 1;
    shot.camera.zfar = 10;
    shot.camera.world[3] = glm::vec4(0, 0, 3, 1);
    shot.look.output = Output::Linear;
    return shot;
}

/// The square with one material.
inline Shot filledBy(const Material& material) {
    SceneBuilder builder;
    builder.add(square(), builder.addMaterial(material));
    return filledBy(builder);
}

inline std::array<int, 3> codesAt(const Picture& picture, int x, int y) {
    const std::uint8_t* const at = picture.rgba.data() + 4 * (picture.width * y + x);
    return {at[0], at[1], at[2]};
}

/// Of the middle.
inline std::array<int, 3> codesOf(const Picture& picture) {
    return codesAt(picture, picture.width / 2, picture.height / 2);
}

/// A picture of one texel.
inline Image texel(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255) {
    return {"texel", 1, 1, {r, g, b, a}};
}

} // namespace franken::test
