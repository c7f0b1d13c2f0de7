// SPDX-License-Identifier: MIT
// From a material and its light to a permutation; no GL.
#include "franken/material.h"
#include "franken/program_uses.h"
#include "franken/viewpoint.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

constexpr VertexContents kAll = {.tangents = true, .uv = {true, true}, .colors = false};

/// A scene with one material and three textures of one pixel.
Scene sceneWith(const Material& material) {
    SceneBuilder builder;
    for (int i = 0; i < 3; ++i)
        builder.addTexture(paint(1, [](glm::vec2) { return glm::vec4(1); }));
    builder.addMaterial(material);
    return builder.scene;
}

glm::mat3 doubled() { return {2, 0, 0, 0, 2, 0, 0, 0, 1}; }

std::string nameOf(const Material& material, const VertexContents& contents = kAll, const Log& log = {}) {
    const MaterialPlan plan = planMaterial(sceneWith(material), 0, contents, log);
    Lighting lighting;
    lighting.ambient.kind = Ambient::Color;
    lighting.suns.resize(1);
    const Result<Permutation> permutation = permutationOf(plan, lighting, {});
    return permutation ? toName(*permutation) : toString(permutation.error());
}

TEST(MaterialPlan, FactorsAlone) { EXPECT_EQ(nameOf({}), "ambient+sun1"); }

TEST(MaterialPlan, AllRoles) {
    Material material;
    material.textures[TextureRole::BaseColor].texture = 0;
    material.textures[TextureRole::MetallicRoughness].texture = 1;
    material.textures[TextureRole::Occlusion].texture = 2;
    material.textures[TextureRole::Normal].texture = 1;
    material.textures[TextureRole::Emissive].texture = 0;
    material.factors.emissive = {1, 1, 1};
    material.alphaMode = AlphaMode::Mask;
    material.doubleSided = true;
    EXPECT_EQ(nameOf(material), "basecolor.metalrough.normal.occlusion.emissive.mask.double+ambient+sun1");
}

TEST(MaterialPlan, OcclusionInThePackedTextureIsFetchedOnce) {
    Material material;
    material.textures[TextureRole::MetallicRoughness].texture = 1;
    material.textures[TextureRole::Occlusion].texture = 1;
    EXPECT_EQ(nameOf(material), "metalrough.occlusion-packed+ambient+sun1");
    material.textures[TextureRole::Occlusion].uvSet = 1;
    EXPECT_EQ(nameOf(material), "metalrough.occlusion.occlusion-uv1+ambient+sun1");
}

TEST(MaterialPlan, MetalnessAndRoughnessMayHaveATextureEach) {
    Material material;
    material.textures[TextureRole::Roughness].texture = 1;
    EXPECT_EQ(nameOf(material), "metalrough-separate+ambient+sun1");
    material.textures[TextureRole::Metallic].texture = 0;
    const MaterialPlan plan = planMaterial(sceneWith(material), 0, kAll);
    EXPECT_EQ(plan.textures[rowOf(TextureRole::Metallic).unit], 0);
    EXPECT_EQ(plan.textures[rowOf(TextureRole::Roughness).unit], 1);
}

TEST(MaterialPlan, ASecondTransformOfTheSameSetIsASecondStream) {
    Material material;
    material.textures[TextureRole::BaseColor].texture = 0;
    material.textures[TextureRole::Normal] = {.texture = 1, .transform = doubled(), .transformed = true};
    const MaterialPlan plan = planMaterial(sceneWith(material), 0, kAll);
    EXPECT_EQ(plan.permutation.normalUv, UvStream::Uv1);
    EXPECT_TRUE(plan.permutation.uv1Transform);
    EXPECT_FALSE(plan.permutation.uv0Transform);
    EXPECT_EQ(plan.uvSets, (std::array{0, 0}));
    EXPECT_EQ(plan.uvTransforms.uv1, (Float9{2, 0, 0, 0, 2, 0, 0, 0, 1}));
}

TEST(MaterialPlan, OnlyTheSecondSetIsTheFirstStream) {
    Material material;
    material.textures[TextureRole::BaseColor] = {.texture = 0, .uvSet = 1};
    const MaterialPlan plan = planMaterial(sceneWith(material), 0, kAll);
    EXPECT_EQ(plan.permutation.baseColorUv, UvStream::Uv0);
    EXPECT_EQ(plan.uvSets[0], 1);
}

TEST(MaterialPlan, AThirdStreamIsLeftOutWithAWarning) {
    Material material;
    material.name = "greedy";
    material.textures[TextureRole::BaseColor].texture = 0;
    material.textures[TextureRole::MetallicRoughness] = {.texture = 1, .uvSet = 1};
    material.textures[TextureRole::Occlusion] = {.texture = 2, .transform = doubled(), .transformed = true};
    std::string said;
    const Log log = [&](LogLevel, std::string_view message) { said += message; };
    EXPECT_EQ(nameOf(material, kAll, log), "basecolor.metalrough.metalrough-uv1+ambient+sun1");
    EXPECT_NE(said.find("greedy"), std::string::npos);
    EXPECT_NE(said.find("occlusion"), std::string::npos);
}

TEST(MaterialPlan, TexturesWithoutCoordinatesAreLeftOut) {
    Material material;
    material.textures[TextureRole::BaseColor].texture = 0;
    material.textures[TextureRole::Normal].texture = 1;
    EXPECT_EQ(nameOf(material, {}), "ambient+sun1");
    EXPECT_EQ(nameOf(material, {.uv = {true, false}}), "basecolor+ambient+sun1");
}

TEST(MaterialPlan, UnlitNeedsNoLight) {
    Material material;
    material.unlit = true;
    material.textures[TextureRole::Normal] = {.texture = 1, .transform = doubled(), .transformed = true};
    EXPECT_EQ(nameOf(material), "unlit");
}

TEST(ProgramUses, OfASceneAreListedOnce) {
    SceneBuilder builder;
    const int plain = builder.addMaterial({});
    Material grey;
    grey.factors.baseColor = {0.5f, 0.5f, 0.5f, 0.5f};
    const int other = builder.addMaterial(grey);
    builder.add(square(), plain);
    builder.add(square(), other);
    const auto uses = usesOf(builder.scene, {}, {});
    ASSERT_TRUE(uses);
    EXPECT_EQ(uses->size(), 1u);
}

TEST(LightingOf, TakesFourOfEachAndWarns) {
    Scene scene;
    scene.lights.resize(6);
    scene.lights.emplace_back().kind = Light::Kind::Spot;
    int warnings = 0;
    const Lighting lighting = lightingOf(scene, [&](LogLevel, std::string_view) { ++warnings; });
    EXPECT_EQ(lighting.suns.size(), 4u);
    ASSERT_EQ(lighting.punctualLights.size(), 1u);
    EXPECT_TRUE(lighting.punctualLights[0].spot);
    EXPECT_EQ(warnings, 1);
}

TEST(Viewpoint, AFramedBoxIsAllInView) {
    for (const double aspect : {0.5, 1.0, 2.0}) {
        const Box box{{-3, 1, -2}, {5, 2, 9}};
        const Viewpoint viewpoint = viewpointOf(framingCamera(box, aspect), aspect);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 point(corner & 1 ? box.min.x : box.max.x, corner & 2 ? box.min.y : box.max.y,
                                   corner & 4 ? box.min.z : box.max.z, 1);
            const glm::dvec4 clip = viewpoint.viewProjection * point;
            EXPECT_LE(std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}), clip.w) << aspect;
        }
    }
}

TEST(Viewpoint, ANarrowTargetSeesTheWholeWidthOfTheCamera) {
    Camera camera;
    camera.aspectRatio = 2;
    const double edge = 2 * std::tan(0.5 * camera.yfov);
    const glm::dvec4 clip = viewpointOf(camera, 1).viewProjection * glm::dvec4(edge, 0, -1, 1);
    EXPECT_NEAR(clip.x / clip.w, 1, 1e-6);
}

// glTF 2.0, 3.10.3: what lies at the near plane is at -1, and what lies at the far one at 1.
TEST(Viewpoint, PlanesAreWhereTheFileSays) {
    for (const auto kind : {Camera::Projection::Perspective, Camera::Projection::Orthographic}) {
        Camera camera;
        camera.projection = kind;
        camera.znear = 2;
        camera.zfar = 10;
        const glm::dmat4 matrix = viewpointOf(camera, 1).viewProjection;
        for (const auto& [distance, depth] : {std::pair(2.0, -1.0), {10.0, 1.0}}) {
            const glm::dvec4 clip = matrix * glm::dvec4(0, 0, -distance, 1);
            EXPECT_NEAR(clip.z / clip.w, depth, 1e-6) << distance;
        }
    }
    Camera endless;
    endless.znear = 2;
    const glm::dmat4 matrix = viewpointOf(endless, 1).viewProjection;
    for (const auto& [distance, depth] : {std::pair(2.0, -1.0), {4.0, 0.0}, {1e9, 1.0}}) {
        const glm::dvec4 clip = matrix * glm::dvec4(0, 0, -distance, 1);
        EXPECT_NEAR(clip.z / clip.w, depth, 1e-6) << distance;
    }
}

TEST(Viewpoint, PlanesAreBroughtInToWhatIsThere) {
    Camera camera;
    camera.znear = 0.01f;
    camera.zfar = 1e6f;
    const Camera tight = tightened(camera, {{-1, -1, -11}, {1, 1, -9}});
    const double radius = std::sqrt(3.0);
    EXPECT_NEAR(tight.znear, 10 - radius, 0.01);
    EXPECT_NEAR(tight.zfar, 10 + radius, 0.01);
    camera.zfar = 0; // Infinite.
    EXPECT_NEAR(tightened(camera, {{-1, -1, -11}, {1, 1, -9}}).zfar, 10 + radius, 0.01);
    camera.znear = 9.5f;
    EXPECT_EQ(tightened(camera, {{-1, -1, -11}, {1, 1, -9}}).znear, 9.5f) << "what was cut off stays so";
    EXPECT_EQ(tightened(camera, {}).znear, 9.5f);
}

TEST(Viewpoint, CornersOfTheScreenLookWhereTheyShow) {
    Camera camera;
    camera.world = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    const Viewpoint viewpoint = viewpointOf(camera, 1.5);
    const glm::dvec3 direction = viewpoint.clipToSky * glm::dvec3(1, -1, 1);
    const glm::dvec4 clip = viewpoint.viewProjection * glm::dvec4(direction, 1);
    EXPECT_NEAR(clip.x / clip.w, 1, 1e-6);
    EXPECT_NEAR(clip.y / clip.w, -1, 1e-6);
}

} // namespace
} // namespace franken::test
