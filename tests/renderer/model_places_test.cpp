// SPDX-License-Identifier: MIT
// One model at many places, its variants, and a sky that is turned.
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <limits>

namespace franken::test {
namespace {

class PlacesTest : public PictureTest {
protected:
    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}; }

    Picture drawn(Renderer& renderer, const Camera& camera) {
        const Result<void> result = renderer.draw(viewpointOf(camera, 1), target());
        EXPECT_TRUE(result) << toString(result.error());
        return readBack();
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, PlacesTest, allBackends(), backendName);

glm::dmat4 at(double x, double y, double z) { return glm::translate(glm::dmat4(1), {x, y, z}); }

Camera camera() {
    Camera camera;
    camera.world = at(0, 0, 6);
    return camera;
}

Lighting sunny() {
    Lighting lighting;
    lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
    lighting.ambient = {.kind = Ambient::Color, .color = {0.2f, 0.2f, 0.2f}};
    return lighting;
}

constexpr glm::vec4 kRed{1, 0.1f, 0.1f, 1}, kGreen{0.1f, 1, 0.1f, 1}, kWhite{1};

/// A square that no mirror and no turn leaves as it is, in front of a ball that glass lets through.
Scene flag(const glm::dmat4& world = glm::dmat4(1)) {
    SceneBuilder builder;
    Material cloth;
    cloth.doubleSided = true;
    cloth.name = "cloth";
    cloth.textures[TextureRole::BaseColor].texture = builder.addTexture(
        paint(16, [](glm::vec2 uv) { return uv.x > 0.5f && uv.y > 0.5f ? kRed : kWhite; }));
    builder.add(square(), builder.addMaterial(cloth), glm::mat4(world));
    Material glass;
    glass.factors.baseColor = {0.2f, 0.3f, 1, 0.5f};
    glass.alphaMode = AlphaMode::Blend;
    builder.add(sphere(6), builder.addMaterial(glass), glm::mat4(world * at(0.5, 0.5, 0)));
    builder.scene.instances[0].name = "flag";
    builder.scene.instances[1].name = "lamp";
    return builder.scene;
}

/// A ball of two variants: "night" glows, and has no texture, so that it is drawn by another program.
Scene lamp() {
    SceneBuilder builder;
    Material day;
    day.factors.baseColor = toFloat4(kGreen);
    day.textures[TextureRole::BaseColor].texture = builder.addTexture(checkers(16, 4, kWhite, kGreen));
    builder.add(sphere(8), builder.addMaterial(day));
    Material night;
    night.factors.baseColor = {0.1f, 0.1f, 0.1f, 1};
    night.factors.emissive = {0.9f, 0.4f, 0.1f};
    Primitive& ball = builder.scene.meshes[0].primitives[0];
    builder.scene.variants = {"day", "night"};
    ball.variantMaterials = {kNone, builder.addMaterial(night)};
    return builder.scene;
}

TEST_P(PlacesTest, APlaceIsDrawnAsASceneThatStandsThere) {
    const glm::dmat4 there = glm::rotate(at(-1, 0.5, 0.3), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    for (const glm::dmat4& world : {there, glm::scale(there, glm::dvec3(-0.8, 0.8, 0.8))}) {
        Renderer expected(gl()), renderer(gl());
        expected.setLighting(sunny());
        renderer.setLighting(sunny());
        Scene placed = flag(world);
        for (Instance& instance : placed.instances)
            instance.mirrored = glm::determinant(glm::dmat3(world)) < 0;
        ASSERT_TRUE(expected.load(placed));
        ASSERT_TRUE(renderer.load(flag()));
        const Result<ModelId> model = renderer.add(flag());
        ASSERT_TRUE(model);
        ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
        ASSERT_TRUE(renderer.setWorld(*renderer.firstPlace(*model), world));
        const Picture picture = drawn(expected, camera());
        EXPECT_LE(compareLit(drawn(renderer, camera()), picture).max(), 1) << "matrices are rounded once";
    }
}

/// The flag on a node that a pose moves, and the lamp on one below that it hides or shows.
Scene posable() {
    Scene scene = flag();
    scene.nodes.resize(2);
    scene.nodes[1].parent = 0;
    scene.instances[0].nodeIndex = 0;
    scene.instances[1].nodeIndex = 1;
    scene.instances[1].offset = scene.instances[1].world;
    return scene;
}

TEST_P(PlacesTest, APoseIsDrawnAsASceneThatIsPosedForGood) {
    Pose pose = restPose(posable());
    pose.nodes[0].local = {.translation = {-1, 0.5, 0.3}, .scale = {-0.8, 0.8, 0.8}};
    pose.nodes[0].local.rotation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(posable(), [] { return Result<Scene>(posable()); });
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}));
    const PlaceId place = *renderer.firstPlace(*model);
    for (const bool visible : {true, false}) {
        pose.nodes[1].visible = visible;
        Scene posed = posable();
        ASSERT_TRUE(applyPose(posed, pose));
        Renderer expected(gl());
        expected.setLighting(sunny());
        ASSERT_TRUE(expected.load(posed));
        const Picture picture = drawn(expected, camera());
        renderer.invalidateState(); // Two renderers share the context.
        ASSERT_TRUE(renderer.setPose(place, pose));
        EXPECT_EQ(compareLit(drawn(renderer, camera()), picture).max(), 0);
        renderer.contextLost();
        ASSERT_TRUE(renderer.restore(gl()));
        EXPECT_EQ(compareLit(drawn(renderer, camera()), picture).max(), 0) << "a pose outlasts the context";
    }
    EXPECT_EQ(renderer.setPose(place, Pose{}).error().code, "pose.nodes");
    EXPECT_EQ(renderer.setPose(PlaceId{}, pose).error().code, "renderer.place");
}

TEST_P(PlacesTest, APoseEndsWhereTheSourceReadsAnotherFile) {
    Scene other = posable();
    other.nodes.resize(3);
    other.instances[1].nodeIndex = 2;
    Renderer expected(gl());
    expected.setLighting(sunny());
    ASSERT_TRUE(expected.load(other));
    const Picture picture = drawn(expected, camera());

    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(posable(), [&] { return Result<Scene>(other); });
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}));
    Pose pose = restPose(posable());
    pose.nodes[0].local.translation = {-1, 0.5, 0.3};
    ASSERT_TRUE(renderer.setPose(*renderer.firstPlace(*model), pose));
    EXPECT_GT(compareLit(drawn(renderer, camera()), picture).max(), 8);
    renderer.contextLost();
    ASSERT_TRUE(renderer.restore(gl()));
    EXPECT_EQ(compareLit(drawn(renderer, camera()), picture).max(), 0);
}

TEST_P(PlacesTest, PlacesShareBuffersTexturesAndPrograms) {
    Renderer renderer(recordingGl(gl()));
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(flag());
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
    drawn(renderer, camera());
    const std::size_t bytes = renderer.memory().used();
    const unsigned compiles = renderer.programCounters().compiles;
    recordedCalls().clear();
    for (int i = 0; i < 9; ++i)
        ASSERT_TRUE(renderer.addPlace(*model, at(i % 3 - 1, i / 3 - 1, 0)));
    drawn(renderer, camera());
    EXPECT_EQ(renderer.frameCounters().drawn, 20u);
    EXPECT_EQ(renderer.memory().used(), bytes);
    EXPECT_EQ(renderer.programCounters().compiles, compiles);
    EXPECT_EQ(countCalls("BufferData") + countCalls("TexImage2D") + countCalls("GenBuffers"), 0u);
    EXPECT_LE(countCalls("UseProgram"), 3u) << "sorted by program over all places";
}

TEST_P(PlacesTest, PlacesMoveHideAndGoWithoutOthers) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(flag());
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
    const Picture one = drawn(renderer, camera());
    const Result<PlaceId> second = renderer.addPlace(*model, at(1.5, 0, 0));
    ASSERT_TRUE(second);
    const Picture both = drawn(renderer, camera());
    EXPECT_GT(compareLit(both, one).max(), 100);
    ASSERT_TRUE(renderer.setVisible(*second, false));
    EXPECT_EQ(compareLit(drawn(renderer, camera()), one).max(), 0);
    EXPECT_EQ(renderer.frameCounters().drawn, 2u);
    ASSERT_TRUE(renderer.setVisible(*second, true));
    EXPECT_EQ(compareLit(drawn(renderer, camera()), both).max(), 0);
    ASSERT_TRUE(renderer.setWorld(*second, at(0, -1.5, 0)));
    EXPECT_GT(compareLit(drawn(renderer, camera()), both).max(), 100);
    ASSERT_TRUE(renderer.setWorld(*second, at(1.5, 0, 0)));
    EXPECT_EQ(compareLit(drawn(renderer, camera()), both).max(), 0);
    renderer.removePlace(*second);
    EXPECT_EQ(compareLit(drawn(renderer, camera()), one).max(), 0);
    renderer.removePlace(*renderer.firstPlace(*model));
    drawn(renderer, camera());
    EXPECT_EQ(renderer.frameCounters().drawn, 0u);
    EXPECT_EQ(renderer.firstPlace(*model).error().code, "renderer.place");
}

TEST_P(PlacesTest, WhatIsWrongIsRefusedAndChangesNothing) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(lamp()), gone = renderer.add(lamp());
    ASSERT_TRUE(model && gone);
    const PlaceId place = *renderer.firstPlace(*model), gonePlace = *renderer.firstPlace(*gone);
    renderer.remove(*gone);
    ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
    const Picture before = drawn(renderer, camera());
    glm::dmat4 broken(1.0), projection(1.0);
    broken[2][1] = std::numeric_limits<double>::quiet_NaN();
    projection[0][3] = 1;
    EXPECT_EQ(renderer.addPlace(*gone).error().code, "renderer.model");
    EXPECT_EQ(renderer.addPlace(*model, broken).error().code, "renderer.transform");
    EXPECT_EQ(renderer.setWorld(place, broken).error().code, "renderer.transform");
    EXPECT_EQ(renderer.setWorld(place, projection).error().code, "renderer.transform");
    EXPECT_EQ(renderer.setWorld(gonePlace, glm::dmat4(1)).error().code, "renderer.place");
    EXPECT_EQ(renderer.setVisible(gonePlace, false).error().code, "renderer.place");
    EXPECT_EQ(renderer.setVariant(gonePlace, "night").error().code, "renderer.place");
    EXPECT_EQ(renderer.setVariant(*gone, "night").error().code, "renderer.model");
    EXPECT_EQ(renderer.setVariant(*model, "dusk").error().code, "renderer.variant");
    EXPECT_NE(renderer.setVariant(place, "dusk").error().remedy.find("day, night"), std::string::npos);
    EXPECT_EQ(renderer.namesOf(*gone).error().code, "renderer.model");
    EXPECT_EQ(renderer.setMaterial(*gone, 0, {}).error().code, "renderer.model");
    EXPECT_EQ(renderer.setMaterial(*model, 2, {}).error().code, "renderer.material");
    EXPECT_EQ(renderer.setMaterial(*model, -1, {}).error().code, "renderer.material");
    Material tooRough, untextured;
    tooRough.factors.roughness = 2;
    untextured.textures[TextureRole::BaseColor].texture = 7;
    EXPECT_EQ(renderer.setMaterial(*model, 0, tooRough).error().code, "renderer.material");
    EXPECT_EQ(renderer.setMaterial(*model, 0, untextured).error().code, "renderer.material");
    EXPECT_EQ(renderer.materialOf(*model, 5).error().code, "renderer.material");
    EXPECT_EQ(renderer.setTexture(*model, 1, checkers(4, 2, kRed, kRed)).error().code, "renderer.texture");
    EXPECT_EQ(renderer.setTexture(*model, 0, Image{"", 4, 4, {}}).error().code, "renderer.image");
    EXPECT_EQ(renderer.setTexture(*gone, 0, checkers(4, 2, kRed, kRed)).error().code, "renderer.model");
    renderer.removePlace(gonePlace);
    EXPECT_EQ(compareLit(drawn(renderer, camera()), before).max(), 0);
}

TEST_P(PlacesTest, VariantsAreChosenByModelAndByPlace) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Result<ModelId> model = renderer.add(lamp());
    ASSERT_TRUE(model);
    ASSERT_TRUE(renderer.show({{*model}}, Wait::Yes));
    EXPECT_EQ(renderer.namesOf(*model)->variants, (std::vector<std::string>{"day", "night"}));
    const Picture day = drawn(renderer, camera());
    ASSERT_TRUE(renderer.setVariant(*model, "night"));
    const Picture night = drawn(renderer, camera());
    EXPECT_GT(compareLit(day, night).max(), 100);
    ASSERT_TRUE(renderer.setVariant(*model, "day"));
    EXPECT_EQ(compareLit(drawn(renderer, camera()), day).max(), 0) << "its mapping leaves the ball as it is";
    const Result<PlaceId> second = renderer.addPlace(*model, at(50, 0, 0));
    ASSERT_TRUE(second);
    ASSERT_TRUE(renderer.setVariant(*second, "night"));
    EXPECT_EQ(compareLit(drawn(renderer, camera()), day).max(), 0);
    Camera there = camera();
    there.world = at(50, 0, 6);
    EXPECT_LE(compareLit(drawn(renderer, there), night).max(), 1);
    ASSERT_TRUE(renderer.setVariant(*model, ""));
    EXPECT_LE(compareLit(drawn(renderer, there), day).max(), 1);
}

TEST_P(PlacesTest, AVariantsProgramsAreKnownBeforehand) {
    Renderer renderer(gl());
    renderer.setLighting(sunny());
    const Scene scene = lamp();
    const auto own = usesOf(scene, sunny(), {}), all = usesOf(scene, sunny(), {}, {}, Variants::All);
    ASSERT_TRUE(own && all);
    EXPECT_EQ(own->size(), 1u);
    EXPECT_EQ(all->size(), 2u);
    ASSERT_TRUE(renderer.load(scene));
    const Result<ModelId> model = renderer.add(scene);
    ASSERT_TRUE(model && renderer.show({{*model}}, Wait::Yes));
    drawn(renderer, camera());
    EXPECT_EQ(renderer.takeMisses().size(), 1u) << "variants that are not chosen compile nothing";
    ASSERT_TRUE(renderer.setVariant(*model, "night"));
    drawn(renderer, camera());
    EXPECT_EQ(renderer.takeMisses().size(), 1u);

    Renderer warm(gl());
    warm.setLighting(sunny());
    ASSERT_TRUE(warm.warmUp(target(), *all));
    const Result<ModelId> other = warm.add(scene);
    ASSERT_TRUE(other && warm.show({{*other}}, Wait::Yes));
    ASSERT_TRUE(warm.setVariant(*other, "night"));
    drawn(warm, camera());
    EXPECT_TRUE(warm.takeMisses().empty());
}

/// Left half one colour, right another, up a third: no turn leaves it as it is.
Environment patchedSky() {
    Environment sky{Environment::Layout::Equirect, 64, 32, {}};
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x)
            sky.texels.push_back(y < 8    ? glm::vec3(0.2f, 0.3f, 1)
                                 : x < 20 ? glm::vec3(1, 0.4f, 0.1f)
                                 : x < 40 ? glm::vec3(0.1f, 0.6f, 0.2f)
                                          : glm::vec3(0.3f));
    sky.texels[12 * 64 + 50] = glm::vec3(3000);
    return sky;
}

TEST_P(PlacesTest, ATurnedSkyIsSeenAsByATurnedCamera) {
    Environment sky = patchedSky();
    const std::optional<Sun> sun = takeSun(sky);
    ASSERT_TRUE(sun && sun->ofSky);
    const SkyboxMap cube = encodeSkybox(sky, 32);
    static const ReflectionMaps maps{filterReflection(sky, kMinReflectionSize), reflectionLookup()}; // Slow.
    SceneBuilder builder;
    Material metal, clay;
    metal.factors.roughness = 0.2f;
    clay.factors.metallic = 0;
    clay.factors.roughness = 0.9f;
    builder.add(sphere(16), builder.addMaterial(metal), glm::mat4(at(-1, 0, 0)));
    builder.add(sphere(16), builder.addMaterial(clay), glm::mat4(at(1, 0, 0)));
    Lighting lighting;
    lighting.suns = {*sun};
    lighting.ambient = {.kind = Ambient::Sky, .sky = skyCoefficients(sky)};
    lighting.reflection = Reflection::Lookup;
    lighting.punctualLights = {{.position = {0, 2, 2}, .intensity = 3}};
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(builder.scene) && renderer.setSkybox(&cube) && renderer.setReflection(&maps));
    renderer.setLighting(lighting);
    const Picture unturned = drawn(renderer, camera());

    const glm::dquat turn = glm::angleAxis(1.1, glm::normalize(glm::dvec3(0.2, 1, 0.1)));
    const glm::dmat4 rotation = glm::mat4_cast(turn);
    // All that is not the sky turns with it, and so does the camera: nothing changes for it.
    lighting.skyRotation = turn;
    const glm::dvec3 light = glm::dmat3(rotation) * glm::dvec3(0, 2, 2);
    lighting.punctualLights[0].position = {light.x, light.y, light.z};
    renderer.setLighting(lighting);
    const Picture unmoved = drawn(renderer, camera());
    EXPECT_GT(compareLit(unmoved, unturned).max(), 50);
    Scene turnedScene = builder.scene;
    for (Instance& instance : turnedScene.instances)
        instance.world = rotation * instance.world;
    ASSERT_TRUE(renderer.load(turnedScene));
    Camera turned = camera();
    turned.world = rotation * turned.world;
    const Picture picture = drawn(renderer, turned);
    EXPECT_LE(compareLit(picture, unturned).max(), 2) << writeDifference("turned_sky", picture, unturned);
    lighting.skyRotation = glm::dquat(0, 0, 0, 0);
    renderer.setLighting(lighting);
    EXPECT_EQ(renderer.draw(viewpointOf(turned, 1), target()).error().code, "renderer.lighting");
}

} // namespace
} // namespace franken::test
