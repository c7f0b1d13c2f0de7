// SPDX-License-Identifier: MIT
// What a ray through a pixel meets is what the pixel shows: with places, variants and changed materials, on
// areas and turned panels.
#include "franken/ray_through.h"
#include "support/draw_scene.h"
#include "support/null_gl.h"
#include "support/shapes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <limits>

namespace franken::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kWidth = 64, kHeight = 48;
using Color = std::array<int, 3>;

/// Colours that every encoding leaves as they are, one for each material.
constexpr std::array<Color, 5> kColors = {
    {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 0}, {0, 255, 255}}};

/// A ball, a square that is seen from behind, one that is seen from its front, and one that is open to both
/// sides; a variant of the ball.
Scene objects() {
    SceneBuilder builder;
    for (const Color& color : kColors) {
        Material material;
        material.unlit = true;
        material.factors.baseColor = toFloat4(glm::vec4(color[0], color[1], color[2], 255) / 255.0f);
        builder.addMaterial(material);
    }
    builder.scene.materials[3].doubleSided = true;
    const auto at = [](float x, float y, float z) { return glm::translate(glm::mat4(1), {x, y, z}); };
    const glm::mat4 turned = glm::rotate(glm::mat4(1), 2.8f, glm::vec3(0, 1, 0));
    builder.add(sphere(10), 0, at(-0.6f, 0.3f, 0) * glm::scale(glm::mat4(1), {0.7f, 0.9f, 0.5f}));
    builder.add(square(), 1, at(0.5f, -0.4f, 0.6f) * turned);
    builder.add(square(), 2, at(0.9f, 0.5f, -0.5f) * glm::scale(glm::mat4(1), {-0.6f, 0.6f, 1}));
    builder.add(square(), 3, at(-0.7f, -0.6f, 0.2f) * turned * glm::scale(glm::mat4(1), glm::vec3(0.5f)));
    builder.scene.variants = {"other"};
    builder.scene.meshes[0].primitives[0].variantMaterials = {4};
    return builder.scene;
}

/// The objects at three places, one of which is hidden, one mirrored and in a variant.
struct Shown {
    explicit Shown(const Gl& gl) : renderer(gl) {
        const Scene scene = objects();
        model = *renderer.add(scene);
        EXPECT_TRUE(renderer.setPickTree(model, *PickTree::of(scene)));
        EXPECT_TRUE(renderer.show({{model}}, Wait::Yes));
        const glm::dmat4 unit(1);
        places = {*renderer.firstPlace(model),
                  *renderer.addPlace(model, glm::translate(unit, {1.2, 0.4, -1.5}) *
                                                glm::scale(unit, {-1.3, 0.8, 1})),
                  *renderer.addPlace(model, glm::translate(unit, {0, 0, 1}))};
        EXPECT_TRUE(renderer.setVariant(places[1], "other"));
        EXPECT_TRUE(renderer.setVisible(places[2], false));
    }

    Renderer renderer;
    ModelId model{};
    std::vector<PlaceId> places;
};

/// Its clipping planes cut the scene.
Camera camera(Camera::Projection projection, float zfar) {
    Camera camera;
    camera.projection = projection;
    camera.xmag = camera.ymag = 1.6f;
    camera.znear = 2.3f;
    camera.zfar = zfar;
    camera.world =
        glm::inverse(glm::lookAt(glm::dvec3(0.5, 0.8, 3), glm::dvec3(0.2, 0, 0), glm::dvec3(0, 1, 0)));
    return camera;
}

/// Where the viewer of a panel sees its point; x to the right and y down.
glm::dvec2 seenAt(Rotation rotation, const glm::dvec2& panel) {
    switch (rotation) {
    case Rotation::Quarter:
        return {kHeight - panel.y, panel.x};
    case Rotation::Half:
        return {kWidth - panel.x, kHeight - panel.y};
    case Rotation::ThreeQuarters:
        return {panel.y, kWidth - panel.x};
    case Rotation::None:
        break;
    }
    return panel;
}

class PickingTest : public OffscreenTest {
protected:
    PickingTest() : OffscreenTest({kWidth, kHeight}) {}

    DrawTarget target() {
        return {.framebuffer = surface().framebuffer(), .width = kWidth, .height = kHeight};
    }

    Color colorAt(const Renderer& renderer, const Viewpoint& viewpoint, const DrawTarget& drawn,
                  const glm::dvec2& panel) {
        const glm::dvec2 point = seenAt(drawn.rotation, panel);
        const Result<Ray> ray = rayThrough(viewpoint, drawn, point.x, point.y);
        EXPECT_TRUE(ray);
        const Result<std::optional<PlaceHit>> hit = renderer.pick(*ray);
        EXPECT_TRUE(hit);
        return *hit ? kColors[static_cast<std::size_t>((**hit).material)] : Color{0, 0, 0};
    }

    /// Rasterisers round vertices to some sixteenth of a pixel: next to an edge, either side counts.
    bool shows(const Renderer& renderer, const Viewpoint& viewpoint, const DrawTarget& drawn,
               const glm::dvec2& center, const Color& color) {
        constexpr double kSubpixel = 0.07;
        for (const double x : {0.0, -kSubpixel, kSubpixel})
            for (const double y : {0.0, -kSubpixel, kSubpixel})
                if (colorAt(renderer, viewpoint, drawn, center + glm::dvec2(x, y)) == color)
                    return true;
        return false;
    }

    /// Draws, and holds each pixel of the area against what is picked there. How many show something.
    int expectPickedAsDrawn(Renderer& renderer, const Camera& from, const DrawTarget& drawn) {
        const Viewpoint viewpoint = viewpointOf(from, aspectOf(drawn));
        EXPECT_TRUE(renderer.draw(viewpoint, drawn));
        const ReadBack picture = readBack();
        const TargetArea area = areaOf(drawn);
        int covered = 0, wrong = 0;
        for (int y = kHeight - area.y - area.height; y < kHeight - area.y; ++y)
            for (int x = area.x; x < area.x + area.width; ++x) {
                const auto pixel = picture.pixel(x, y);
                const Color color{pixel[0], pixel[1], pixel[2]};
                covered += color != Color{0, 0, 0} ? 1 : 0;
                wrong += shows(renderer, viewpoint, drawn, glm::dvec2(x, y) + 0.5, color) ? 0 : 1;
            }
        EXPECT_EQ(wrong, 0) << "pixels";
        EXPECT_LT(covered, area.width * area.height) << "some show the background";
        return covered;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, PickingTest, allBackends(), backendName);

TEST_P(PickingTest, MeetsWhatEachPixelShows) {
    Shown shown(gl());
    EXPECT_GT(expectPickedAsDrawn(shown.renderer, camera(Camera::Projection::Perspective, 5), target()), 600);
    EXPECT_GT(expectPickedAsDrawn(shown.renderer, camera(Camera::Projection::Perspective, 0), target()), 600);
    EXPECT_GT(expectPickedAsDrawn(shown.renderer, camera(Camera::Projection::Orthographic, 5), target()),
              600);
}

TEST_P(PickingTest, MeetsWhatATurnedPanelAndAnAreaShow) {
    Shown shown(gl());
    for (const Rotation rotation :
         {Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters}) {
        SCOPED_TRACE(toDegrees(rotation));
        DrawTarget drawn = target();
        drawn.rotation = rotation;
        EXPECT_GT(expectPickedAsDrawn(shown.renderer, camera(Camera::Projection::Perspective, 5), drawn),
                  300);
        drawn.area = TargetArea{21, 4, 40, 17};
        EXPECT_GT(expectPickedAsDrawn(shown.renderer, camera(Camera::Projection::Perspective, 5), drawn), 50);
    }
}

TEST_P(PickingTest, FollowsChanges) {
    Shown shown(gl());
    Renderer& renderer = shown.renderer;
    const Camera from = camera(Camera::Projection::Perspective, 5);
    Material open = *renderer.materialOf(shown.model, 1);
    open.doubleSided = true;
    ASSERT_TRUE(renderer.setMaterial(shown.model, 1, open));
    ASSERT_TRUE(renderer.setVariant(shown.places[0], "other"));
    ASSERT_TRUE(renderer.setWorld(shown.places[1], glm::translate(glm::dmat4(1), {-1, -0.5, -0.7})));
    expectPickedAsDrawn(renderer, from, target());
    ASSERT_TRUE(renderer.setVisible(shown.places[0], false));
    ASSERT_TRUE(renderer.setVisible(shown.places[2], true));
    expectPickedAsDrawn(renderer, from, target());
    renderer.removePlace(shown.places[2]);
    expectPickedAsDrawn(renderer, from, target());
    ASSERT_TRUE(renderer.show({}));
    EXPECT_EQ(expectPickedAsDrawn(renderer, from, target()), 0);
}

TEST(Picking, SaysWhichPlaceIsHitAndWhere) {
    Shown shown(nullGl());
    const Result<std::optional<PlaceHit>> hit =
        shown.renderer.pick({.origin = {1.2 + 1.3 * 0.6, 0.4 + 0.8 * 0.3, 9}, .direction = {0, 0, -3}});
    ASSERT_TRUE(hit && *hit);
    EXPECT_EQ((**hit).model, shown.model);
    EXPECT_EQ((**hit).place, shown.places[1]);
    EXPECT_EQ((**hit).instance, 0);
    EXPECT_EQ((**hit).material, 4) << "of the place's variant";
    EXPECT_NEAR((**hit).distance, 9 - (-1.5 + 0.5), 1e-6);
    EXPECT_LT(glm::distance((**hit).point, {1.98, 0.64, -1.0}), 1e-6);
}

TEST(Picking, NeedsNoContextAndATreeOfTheModel) {
    Shown shown(nullGl());
    const Ray ray{.origin = {-0.6, 0.3, 9}};
    EXPECT_TRUE(*shown.renderer.pick(ray));
    shown.renderer.contextLost();
    EXPECT_TRUE(*shown.renderer.pick(ray));
    ASSERT_TRUE(shown.renderer.setPickTree(shown.model, std::nullopt));
    EXPECT_FALSE(*shown.renderer.pick(ray));
    const Scene scene = objects();
    EXPECT_EQ(shown.renderer.setPickTree(shown.model, *PickTree::of({})).error().code, "renderer.tree");
    EXPECT_EQ(shown.renderer.setPickTree(ModelId{}, *PickTree::of(scene)).error().code, "renderer.model");
    ASSERT_TRUE(shown.renderer.setPickTree(shown.model, *PickTree::of(scene)));
    EXPECT_TRUE(*shown.renderer.pick(ray));
    EXPECT_EQ(shown.renderer.pick({.direction = {0, 0, 0}}).error().code, "pick.ray");
}

TEST(Picking, MeetsWhatTheOriginLiesOnAndNothingOfAFlatPlace) {
    Shown shown(nullGl());
    const Result<std::optional<PlaceHit>> hit = shown.renderer.pick({.origin = {0.9, 0.5, -0.5}});
    ASSERT_TRUE(hit && *hit);
    EXPECT_EQ((**hit).distance, 0);
    for (const PlaceId place : shown.places)
        ASSERT_TRUE(shown.renderer.setWorld(place, glm::scale(glm::dmat4(1), {1, 1, 0})));
    EXPECT_FALSE(*shown.renderer.pick({.origin = {-0.6, 0.3, 9}}));
}

TEST(RayThrough, SaysWhatIsWrong) {
    const Viewpoint good = viewpointOf(camera(Camera::Projection::Perspective, 5), 1);
    const DrawTarget target{.width = kWidth, .height = kHeight};
    EXPECT_EQ(rayThrough(good, target, kNaN, 0).error().code, "renderer.point");
    EXPECT_EQ(rayThrough(good, {}, 1, 1).error().code, "renderer.target");
    Viewpoint bad = good;
    bad.eye.x = kNaN;
    EXPECT_EQ(rayThrough(bad, target, 1, 1).error().code, "renderer.viewpoint");
    bad = good;
    bad.viewProjection = glm::dmat4(0);
    EXPECT_EQ(rayThrough(bad, target, 1, 1).error().code, "renderer.viewpoint");
}

TEST(RayThrough, GoesFromTheNearPlaneToTheFarOne) {
    Camera from;
    from.yfov = 2 * std::atan(0.5f);
    from.znear = 2;
    from.zfar = 10;
    const glm::dvec3 place(6'371'000, -4'000'000, 0);
    from.world[3] = glm::dvec4(place, 1);
    const DrawTarget target{.width = 100, .height = 100};
    const Ray middle = *rayThrough(viewpointOf(from, 1), target, 50, 50);
    EXPECT_LT(glm::distance(middle.origin, place + glm::dvec3(0, 0, -2)), 1e-6);
    EXPECT_LT(glm::distance(middle.direction, {0, 0, -1}), 1e-9);
    EXPECT_NEAR(middle.length, 8, 1e-6);
    const Ray corner = *rayThrough(viewpointOf(from, 1), target, 100, 0);
    EXPECT_LT(glm::distance(corner.direction, glm::normalize(glm::dvec3(0.5, 0.5, -1))), 1e-7);
    from.zfar = 0;
    EXPECT_EQ(rayThrough(viewpointOf(from, 1), target, 50, 50)->length,
              std::numeric_limits<double>::infinity());
}

} // namespace
} // namespace franken::test
