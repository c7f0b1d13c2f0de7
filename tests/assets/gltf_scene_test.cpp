// SPDX-License-Identifier: MIT
// The node tree: placement, instances, poses, cameras and lights.
#include <cmath>
#include <cstdint>
#include <fstream>

#include <glm/geometric.hpp>

#include "franken/pose.h"
#include "gltf_file.h"
#include "support/shell.h"

namespace {

using franken::Camera;
using franken::Light;
using franken::Scene;
using Json = GltfFile::Json;

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-6f) {
    EXPECT_LE(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

glm::vec3 placed(const glm::mat4& world, const glm::vec3& point) {
    return glm::vec3(world * glm::vec4(point, 1));
}

TEST(GltfNode, TransformsAccumulate) {
    GltfFile file;
    file.setTriangle();
    const double half = std::sqrt(0.5); // a quarter turn about +Z: x goes to y
    file.json["nodes"] = {{{"translation", {1, 2, 3}}, {"rotation", {0, 0, half, half}}, {"children", {1}}},
                          {{"scale", {2, 3, 4}}, {"mesh", 0}, {"name", "leaf"}}};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "leaf");
    EXPECT_FALSE(scene.instances[0].mirrored);
    expectNear(placed(scene.instances[0].world, {1, 0, 0}), {1, 4, 3});
    expectNear(placed(scene.instances[0].world, {0, 1, 0}), {-2, 2, 3});
    expectNear(scene.bounds().min, {-2, 2, 3});
    expectNear(scene.bounds().max, {1, 4, 3});
}

TEST(GltfNode, MatrixIsColumnMajorAndNegativeScaleIsMirrored) {
    GltfFile file;
    file.setTriangle();
    file.json["nodes"] = {{{"mesh", 0}, {"matrix", {-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}},
                          {{"mesh", 0}, {"scale", {-1, -1, 1}}},
                          {{"mesh", 0}, {"scale", {-1, -1, -1}}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 1u) << "the mesh is shared";
    expectNear(placed(scene.instances[0].world, {1, 0, 0}), {3, 6, 7});
    EXPECT_TRUE(scene.instances[0].mirrored);
    EXPECT_FALSE(scene.instances[1].mirrored);
    EXPECT_TRUE(scene.instances[2].mirrored);
}

TEST(GltfNode, WhichSceneIsDrawn) {
    GltfFile file;
    file.setTriangle();
    file.json["nodes"] = {{{"mesh", 0}, {"name", "a"}},
                          {{"mesh", 0}, {"name", "b"}, {"children", {2}}},
                          {{"mesh", 0}, {"name", "c"}}};
    file.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {2, 1}}}};
    file.json["scene"] = 1;
    Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 2u) << "a child that is listed as a root is drawn once";
    EXPECT_EQ(scene.instances[0].name, "c");
    file.json.erase("scene");
    scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "a");
    file.json.erase("scenes");
    EXPECT_EQ(file.loaded().instances.size(), 3u);
}

TEST(GltfNode, MorphWeightsAreApplied) {
    GltfFile file;
    file.setTriangle();
    const int deltas = file.floats("VEC3", {0, 0, 1, 0, 0, 2, 0, 0, 4});
    file.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", deltas}}};
    file.json["meshes"][0]["weights"] = {0.5};
    file.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"weights", {2}}}, {{"mesh", 0}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.meshes.size(), 3u) << "one for each node that can be posed";
    expectNear(scene.meshes[0].primitives[0].positions[2], {0, 1, 2});
    expectNear(scene.meshes[1].primitives[0].positions[2], {0, 1, 8});
    EXPECT_EQ(scene.meshes[2].primitives[0].deformation, scene.meshes[0].primitives[0].deformation);
    // Flat normals are those of the morphed triangle.
    expectNear(scene.meshes[1].primitives[0].normals[0], glm::normalize(glm::vec3(-2, -6, 1)));
}

TEST(GltfNode, TheSkinIsAppliedAtRest) {
    GltfFile file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int joints = file.accessor("VEC4", GltfFile::kUByte,
                                     std::vector<std::uint8_t>{0, 9, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    const int weights = file.floats("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
    const int inverse = file.floats("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                             1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    file.setPrimitive(
        {{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    file.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
    file.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                          {{"translation", {0, 0, 2}}},
                          {{"translation", {5, 0, 0}}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 1u);
    expectNear(glm::vec3(scene.instances[0].world[3]), {0, 0, 2});
    const auto& moved = scene.meshes[0].primitives[0].positions;
    const glm::mat4 world(
        scene.instances[0].world); // The first joint's place; the node's own does not count.
    expectNear(placed(world, moved[0]), {0, 0, 2});
    expectNear(placed(world, moved[1]), {5, 0, 0});
    expectNear(placed(world, moved[2]), {2, 1, 1});
    EXPECT_TRUE(file.warnings.empty());
    ASSERT_EQ(scene.skins.size(), 1u);
    EXPECT_EQ(scene.instances[0].skin, 0);
    EXPECT_EQ(scene.skins[0].inverseBinds[1][3][0], -1);
}

TEST(GltfNode, InstancesHaveAPlaceEach) {
    GltfFile file;
    file.setTriangle();
    const int moves = file.floats("VEC3", {1, 0, 0, 0, 2, 0});
    const int turns =
        file.accessor("VEC4", GltfFile::kByte, std::vector<std::int8_t>{127, 0, 0, 0, 0, 127, 0, 0});
    file.json["accessors"][static_cast<std::size_t>(turns)]["normalized"] = true;
    const int scales = file.floats("VEC3", {1, 1, 1, -2, 2, 2});
    file.json["nodes"] = {{{"mesh", 0}, {"translation", {0, 0, 5}}}};
    const Json attributes = {{"TRANSLATION", moves}, {"ROTATION", turns}, {"SCALE", scales}, {"_ID", 0}};
    file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    file.json["scenes"][0]["nodes"] = {0};
    Scene scene = file.loaded();
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    expectNear(placed(glm::mat4(scene.instances[0].world), {0, 1, 0}), {1, -1, 5});
    expectNear(placed(glm::mat4(scene.instances[1].world), {1, 0, 0}), {2, 2, 5});
    EXPECT_TRUE(scene.instances[1].mirrored);
    franken::Pose pose = franken::restPose(scene);
    pose.nodes[0].local.translation = {0, 0, 7};
    ASSERT_TRUE(franken::applyPose(scene, pose));
    expectNear(glm::vec3(scene.instances[1].world[3]), {0, 2, 7});
    EXPECT_TRUE(file.warnings.empty());
}

TEST(GltfNode, MoreThanFourJointsCount) {
    GltfFile file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int joints = file.accessor("VEC4", GltfFile::kUByte, std::vector<std::uint8_t>(12, 0));
    const int others = file.accessor("VEC4", GltfFile::kUByte, std::vector<std::uint8_t>(12, 1));
    const int weights = file.floats("VEC4", std::vector<float>(12, 0.5f));
    file.setPrimitive({{"attributes",
                        {{"POSITION", positions},
                         {"JOINTS_0", joints},
                         {"WEIGHTS_0", weights},
                         {"JOINTS_1", others},
                         {"WEIGHTS_1", weights}}}});
    file.json["skins"] = {{{"joints", {1, 2}}}};
    file.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, Json::object(), {{"translation", {2, 0, 0}}}};
    file.json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = file.loaded();
    expectNear(scene.meshes[0].primitives[0].positions[0], {1, 0, 0});
    EXPECT_EQ(scene.meshes[0].primitives[0].deformation->influencesPerVertex, 8u);
    EXPECT_TRUE(file.warnings.empty());
}

TEST(GltfNode, Cameras) {
    GltfFile file;
    file.json["cameras"] = {
        {{"type", "perspective"},
         {"perspective", {{"yfov", 0.7}, {"znear", 0.01}, {"zfar", 50}, {"aspectRatio", 1.5}}}},
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 1}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 9}}}}};
    file.json["nodes"] = {{{"camera", 0}, {"translation", {0, 0, 4}}}, {{"camera", 1}}, {{"camera", 2}}};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_FLOAT_EQ(scene.cameras[0].yfov, 0.7f);
    EXPECT_FLOAT_EQ(scene.cameras[0].aspectRatio, 1.5f);
    EXPECT_FLOAT_EQ(scene.cameras[0].zfar, 50);
    expectNear(glm::vec3(scene.cameras[0].world[3]), {0, 0, 4});
    EXPECT_EQ(scene.cameras[1].zfar, 0) << "infinite";
    EXPECT_EQ(scene.cameras[2].projection, Camera::Projection::Orthographic);
    EXPECT_EQ(scene.cameras[2].xmag, 2);
    EXPECT_EQ(scene.cameras[2].ymag, 3);
}

TEST(GltfNode, Lights) {
    GltfFile file;
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 3}, {"color", {1, 0.5, 0}}},
        {{"type", "point"}, {"range", 7}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    const double half = std::sqrt(0.5);
    for (int light = 0; light < 3; ++light)
        file.append("nodes", {{"rotation", {-half, 0, 0, half}}, // a quarter turn: -Z goes to -Y
                              {"scale", {2, 2, 2}},
                              {"translation", {light, 0, 0}},
                              {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].kind, Light::Kind::Directional);
    EXPECT_FLOAT_EQ(scene.lights[0].intensity, 3);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(1, 0.5f, 0));
    expectNear(scene.lights[0].direction, {0, -1, 0});
    EXPECT_EQ(scene.lights[1].kind, Light::Kind::Point);
    EXPECT_EQ(scene.lights[1].range, 7);
    expectNear(scene.lights[1].position, {1, 0, 0});
    EXPECT_EQ(scene.lights[2].kind, Light::Kind::Spot);
    EXPECT_FLOAT_EQ(scene.lights[2].outerConeAngle, 0.2f);
    EXPECT_EQ(scene.lights[2].range, 0);
}

TEST(GltfNode, ADeepTreeNeedsNoStack) {
    GltfFile file;
    file.setTriangle();
    file.json["nodes"] = Json::array();
    constexpr int kDepth = 100'000;
    for (int i = 0; i + 1 < kDepth; ++i)
        file.append("nodes", {{"children", {i + 1}}});
    file.append("nodes", {{"mesh", 0}});
    EXPECT_EQ(file.loaded().instances.size(), 1u);
}

TEST(GltfNode, BinaryContainerGivesTheSame) {
    GltfFile file;
    file.setTriangle();
    const auto path = file.write(true);
    const auto scene = franken::loadGltf(path);
    std::filesystem::remove(path);
    ASSERT_TRUE(scene) << toString(scene.error());
    EXPECT_EQ(scene->meshes[0].primitives[0].positions, file.loaded().meshes[0].primitives[0].positions);
}

TEST(GltfScene, SaysWhichFilesItWasReadFrom) {
    GltfFile file;
    file.setTriangle();
    for (const char* image : {"image.png", "missing.png", "data:image/png;base64,AAAA"})
        file.append("images", {{"uri", image}});
    const std::filesystem::path folder = std::filesystem::canonical(franken::test::emptyTestFolder());
    const std::string bytes = file.bytes(false);
    std::ofstream(folder / "model.gltf", std::ios::binary) << bytes;
    std::ofstream(folder / "image.png") << "no picture, but a file";
    const auto scene = franken::loadGltf(folder / "model.gltf");
    ASSERT_TRUE(scene) << toString(scene.error());
    EXPECT_EQ(scene->files,
              (std::vector<std::filesystem::path>{folder / "model.gltf", folder / "image.png"}));
    const auto fromMemory =
        franken::loadGltf({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, "memory");
    ASSERT_TRUE(fromMemory) << toString(fromMemory.error());
    EXPECT_TRUE(fromMemory->files.empty());
}

} // namespace
