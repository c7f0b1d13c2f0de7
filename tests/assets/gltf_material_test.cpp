// SPDX-License-Identifier: MIT
// Materials, textures, samplers and images.
#include <cmath>
#include <limits>

#include "franken/scene_check.h"
#include "gltf_file.h"

namespace {

using franken::AlphaMode;
using franken::Filter;
using franken::Material;
using franken::Scene;
using franken::TextureRef;
using franken::TextureRole;
using franken::TextureRoleRow;
using franken::textureRoles;
using franken::Wrap;
using Json = GltfFile::Json;

Material onlyMaterial(GltfFile& file, const Json& material) {
    file.setTriangle();
    file.json["materials"] = Json::array({material});
    file.json["meshes"][0]["primitives"][0]["material"] = 0;
    const Scene scene = file.loaded();
    return scene.materials.empty() ? Material() : scene.materials[0];
}

TEST(GltfMaterial, DefaultsAreThoseOfTheSpecification) {
    GltfFile file;
    const Material material = onlyMaterial(file, Json::object());
    EXPECT_EQ(material.factors.baseColor, (franken::Float4{1, 1, 1, 1}));
    EXPECT_EQ(material.factors.metallic, 1);
    EXPECT_EQ(material.factors.roughness, 1);
    EXPECT_EQ(material.factors.emissive, (franken::Float3{0, 0, 0}));
    EXPECT_EQ(material.alphaMode, AlphaMode::Opaque);
    EXPECT_FALSE(material.doubleSided || material.unlit || material.textures[TextureRole::BaseColor] ||
                 material.textures[TextureRole::Normal]);
}

TEST(GltfMaterial, APrimitiveWithoutOneGetsADefault) {
    GltfFile file;
    file.setTriangle();
    file.json["materials"] = {{{"name", "other"}}};
    const Scene scene = file.loaded();
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.meshes[0].primitives[0].material, 1);
}

TEST(GltfMaterial, AllIsRead) {
    GltfFile file;
    const int texture = file.appendTexture();
    const Json ref{{"index", texture}, {"texCoord", 1}};
    Json normal = ref, occlusion = ref;
    normal["scale"] = 0.5;
    occlusion["strength"] = 0.25;
    file.json["extensionsUsed"] = {"KHR_materials_unlit", "KHR_materials_emissive_strength"};
    const Material material =
        onlyMaterial(file, {{"name", "paint"},
                            {"pbrMetallicRoughness",
                             {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                              {"metallicFactor", 0.5},
                              {"roughnessFactor", 0.6},
                              {"baseColorTexture", ref},
                              {"metallicRoughnessTexture", ref}}},
                            {"normalTexture", normal},
                            {"occlusionTexture", occlusion},
                            {"emissiveTexture", ref},
                            {"emissiveFactor", {1, 0.5, 0}},
                            {"alphaMode", "MASK"},
                            {"alphaCutoff", 0.7},
                            {"doubleSided", true},
                            {"extensions",
                             {{"KHR_materials_unlit", Json::object()},
                              {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
    EXPECT_EQ(material.name, "paint");
    EXPECT_EQ(material.factors.baseColor, (franken::Float4{0.1f, 0.2f, 0.3f, 0.4f}));
    EXPECT_FLOAT_EQ(material.factors.metallic, 0.5f);
    EXPECT_FLOAT_EQ(material.factors.roughness, 0.6f);
    EXPECT_FLOAT_EQ(material.factors.normalScale, 0.5f);
    EXPECT_FLOAT_EQ(material.factors.occlusionStrength, 0.25f);
    EXPECT_EQ(material.factors.emissive, (franken::Float3{4, 2, 0}));
    EXPECT_EQ(material.alphaMode, AlphaMode::Mask);
    EXPECT_FLOAT_EQ(material.factors.alphaCutoff, 0.7f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(material.unlit);
    for (const TextureRoleRow& role : textureRoles())
        if (!role.gltf.empty()) {
            const TextureRef& use = material.textures[role.role];
            EXPECT_EQ(use.texture, texture) << role.name;
            EXPECT_EQ(use.uvSet, 1) << role.name;
            EXPECT_FALSE(use.transformed) << role.name;
        }
}

TEST(GltfMaterial, EachNumberOfAFactorIsReadAndHeld) {
    for (const franken::FactorRow& row : franken::kMaterialFactors) {
        Material material;
        const std::size_t count = row.of(material.factors).size();
        const Json::json_pointer place{std::string(row.gltf)};
        for (std::size_t i = 0; i < count; ++i) {
            GltfFile file;
            Json numbers = Json(std::vector<double>(count, 0.25)), wanted = Json::object();
            numbers[i] = -0.75;
            wanted[place] = count == 1 ? numbers[0] : numbers;
            for (const char* texture : {"normalTexture", "occlusionTexture"})
                if (wanted.contains(texture))
                    wanted[texture]["index"] = file.appendTexture();
            material = onlyMaterial(file, wanted);
            const auto read = row.of(material.factors);
            EXPECT_EQ(read[i], row.inFile.least < 0 ? -0.75f : 0.0f) << row.name << i;
            EXPECT_EQ(read[(i + 1) % count], count == 1 ? read[0] : 0.25f) << row.name << i;
            read[i] = std::numeric_limits<float>::quiet_NaN();
            material.textures = {}; // Of another scene.
            const auto checked = check(Scene(), material);
            ASSERT_FALSE(checked) << row.name << i;
            EXPECT_EQ(checked.error().where, "material.factors." + std::string(row.name));
        }
    }
}

struct TransformRow {
    const char* name;
    Json extension;
    glm::vec2 uv, expected;
};

class TextureTransform : public testing::TestWithParam<TransformRow> {};

TEST_P(TextureTransform, MovesUv) {
    GltfFile file;
    file.json["extensionsUsed"] = {"KHR_texture_transform"};
    const Json use{{"index", file.appendTexture()},
                   {"extensions", {{"KHR_texture_transform", GetParam().extension}}}};
    const Material material = onlyMaterial(file, {{"emissiveTexture", use}});
    const glm::vec2 uv(material.textures[TextureRole::Emissive].transform * glm::vec3(GetParam().uv, 1));
    EXPECT_NEAR(uv.x, GetParam().expected.x, 1e-6);
    EXPECT_NEAR(uv.y, GetParam().expected.y, 1e-6);
}

constexpr double kQuarter = 1.57079632679;
// "lowerLeft" is the first example of the extension's text: the lower left quadrant, turned clockwise.
INSTANTIATE_TEST_SUITE_P(
    , TextureTransform,
    testing::Values(TransformRow{"nothing", Json::object(), {0.3f, 0.4f}, {0.3f, 0.4f}},
                    TransformRow{"offset", {{"offset", {0.5, 0.25}}}, {0, 1}, {0.5f, 1.25f}},
                    TransformRow{"scale", {{"scale", {2, -1}}}, {0.5f, 0.5f}, {1, -0.5f}},
                    TransformRow{"rotation", {{"rotation", kQuarter}}, {1, 0}, {0, -1}},
                    TransformRow{"lowerLeft",
                                 {{"offset", {0, 1}}, {"rotation", kQuarter}, {"scale", {0.5, 0.5}}},
                                 {1, 1},
                                 {0.5f, 0.5f}}),
    [](const auto& row) { return row.param.name; });

TEST(GltfMaterial, TextureTransformOverridesTheUvSet) {
    GltfFile file;
    const Json use{{"index", file.appendTexture()},
                   {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}, {"scale", {2, 2}}}}}}};
    const Material material = onlyMaterial(file, {{"emissiveTexture", use}});
    EXPECT_EQ(material.textures[TextureRole::Emissive].uvSet, 1);
    EXPECT_TRUE(material.textures[TextureRole::Emissive].transformed);
}

TEST(GltfMaterial, AThirdUvSetIsDropped) {
    GltfFile file;
    const Material material =
        onlyMaterial(file, {{"emissiveTexture", {{"index", file.appendTexture()}, {"texCoord", 2}}}});
    EXPECT_FALSE(material.textures[TextureRole::Emissive]);
    EXPECT_EQ(file.warnings.size(), 1u);
}

TEST(GltfMaterial, FactorsAreClampedWithAWarning) {
    GltfFile file;
    const Material material = onlyMaterial(file, {{"pbrMetallicRoughness", {{"metallicFactor", 1.5}}}});
    EXPECT_EQ(material.factors.metallic, 1);
    EXPECT_EQ(file.warnings.size(), 1u);
}

TEST(GltfTexture, SamplersAndDefaults) {
    GltfFile file;
    const int plain = file.appendTexture(), sampled = file.appendTexture();
    file.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}}};
    file.json["textures"][sampled]["sampler"] = 0;
    onlyMaterial(file, {{"emissiveTexture", {{"index", plain}}}});
    const Scene scene = file.loaded();
    EXPECT_EQ(scene.textures[plain].wrapS, Wrap::Repeat);
    EXPECT_EQ(scene.textures[plain].magFilter, Filter::Linear);
    EXPECT_EQ(scene.textures[plain].minFilter, Filter::LinearMipmapLinear);
    EXPECT_EQ(scene.textures[sampled].wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(scene.textures[sampled].wrapT, Wrap::MirroredRepeat);
    EXPECT_EQ(scene.textures[sampled].magFilter, Filter::Nearest);
    EXPECT_EQ(scene.textures[sampled].minFilter, Filter::LinearMipmapNearest);
}

TEST(GltfTexture, ABrokenOrMissingImageIsLeftOut) {
    for (const char* uri : {"missing.png", "data:image/png;base64,AAAA"}) {
        GltfFile file;
        const int texture = file.appendTexture();
        file.json["images"][0]["uri"] = uri;
        const Material material = onlyMaterial(file, {{"normalTexture", {{"index", texture}}}});
        EXPECT_FALSE(material.textures[TextureRole::Normal]) << uri;
        ASSERT_EQ(file.warnings.size(), 1u) << uri;
        EXPECT_NE(file.warnings[0].find("/images/0"), std::string::npos) << file.warnings[0];
    }
}

TEST(GltfTexture, OnlyUsedImagesAreDecoded) {
    GltfFile file;
    const int used = file.appendTexture(), unused = file.appendTexture();
    file.json["images"][unused]["uri"] = "data:image/png;base64,AAAA";
    onlyMaterial(file, {{"emissiveTexture", {{"index", used}}}});
    EXPECT_TRUE(file.warnings.empty());
}

TEST(GltfTexture, TheLimitOfSizeIsKept) {
    GltfFile file;
    onlyMaterial(file, {{"emissiveTexture", {{"index", file.appendTexture()}}}});
    franken::LoadOptions options;
    options.maxImageSize = 0;
    const auto scene = file.load(options);
    ASSERT_TRUE(scene);
    EXPECT_FALSE(scene->materials[0].textures[TextureRole::Emissive]);
    EXPECT_NE(file.warnings.back().find("image.size"), std::string::npos);
}

} // namespace
