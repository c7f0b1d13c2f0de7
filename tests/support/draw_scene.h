// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "support/image_diff.h"
#include "support/offscreen.h"

#include <filesystem>
#include <optional>

namespace franken::test {

/// What to draw, and how.
struct Shot {
    Scene scene;
    Camera camera;
    Lighting lighting;
    Look look = {};
    std::optional<SkyboxMap> skybox = {};
    std::optional<ReflectionMaps> reflection = {};
    Float3 background{0, 0, 0};
};

/// A file's scene as it is, with its first camera (or one that frames it) and its lights. Adds a failure to
/// the running test where it does not load.
Shot shotOf(const std::filesystem::path& file);

/// Draws to all of the surface, which must be current. Adds a failure where that fails, and where GL reports
/// an error.
void drawShot(const Gl& gl, const platform::Surface& surface, const Shot& shot);

/// The same for a context of which that is believed.
void drawShot(const Gl& gl, const platform::Surface& surface, const Shot& shot,
              const Capabilities& capabilities);

/// The same for another target, with the shot's background.
void drawShot(const Gl& gl, DrawTarget target, const Shot& shot, const Capabilities& capabilities);

/// The forms of the text that any picture must look the same with: for any GPU, and what VideoCore IV runs
/// best. A software rasteriser computes both to the last bit of a float; how inexact VideoCore IV is stands
/// in tests/qpu/precision.
inline constexpr Target kForms[] = {Target::Generic, Target::Vc4};

/// The shot, drawn with the forms for a GPU.
Shot withForms(Shot shot, Target target);

/// What an engine might leave GL at: everything that drawing depends on is another way round.
void disturbState(const Gl& gl);

/// A PNG or JPEG. Adds a failure where it does not load.
Picture readPicture(const std::filesystem::path& file);

/// A file or folder beside the source tree, in `../shared`; empty where it is not there.
std::filesystem::path findShared(const std::string& path);

/// Draws shots on every backend.
class PictureTest : public OffscreenTest {
protected:
    using OffscreenTest::OffscreenTest;

    Picture draw(const Shot& shot) {
        drawShot(gl(), surface(), shot);
        return readBack();
    }
};

} // namespace franken::test
