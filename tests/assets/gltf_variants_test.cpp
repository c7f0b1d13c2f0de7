// SPDX-License-Identifier: MIT
// KHR_materials_variants.
#include "franken/scene_check.h"
#include "gltf_file.h"

namespace {

using franken::kNone;
using franken::Scene;
using Json = GltfFile::Json;

/// A triangle with three materials, and mappings.
GltfFile fileWith(const Json& mappings, const Json& variants) {
    GltfFile file;
    file.setTriangle();
    file.json["materials"] = {{{"name", "plain"}}, {{"name", "red"}}, {{"name", "bumpy"}}};
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["material"] = 0;
    primitive["extensions"]["KHR_materials_variants"]["mappings"] = mappings;
    file.json["extensions"]["KHR_materials_variants"]["variants"] = variants;
    file.json["extensionsUsed"] = {"KHR_materials_variants"};
    return file;
}

const Json kDayAndNight = {{{"name", "day"}}, {{"name", "night"}}, {{"name", "dawn"}}};

TEST(GltfVariants, EachPrimitiveHasAMaterialInEachVariant) {
    GltfFile file = fileWith({{{"material", 1}, {"variants", {0, 2}}}, {{"material", 2}, {"variants", {1}}}},
                             kDayAndNight);
    const Scene scene = file.loaded();
    EXPECT_EQ(scene.variants, (std::vector<std::string>{"day", "night", "dawn"}));
    const franken::Primitive& primitive = scene.meshes.at(0).primitives.at(0);
    EXPECT_EQ(primitive.material, 0);
    EXPECT_EQ(primitive.variantMaterials, (std::vector<int>{1, 2, 1}));
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_TRUE(franken::check(scene));
}

TEST(GltfVariants, RequiredOrNotTheyAreKnown) {
    GltfFile file = fileWith({{{"material", 1}, {"variants", {1}}}}, kDayAndNight);
    file.json["extensionsRequired"] = {"KHR_materials_variants"};
    EXPECT_EQ(file.loaded().meshes.at(0).primitives.at(0).variantMaterials,
              (std::vector<int>{kNone, 1, kNone}));
    EXPECT_TRUE(file.warnings.empty());
}

TEST(GltfVariants, MaterialsOfVariantsAreReadWithTheirImagesAndTangents) {
    GltfFile file = fileWith({{{"material", 2}, {"variants", {1}}}}, kDayAndNight);
    file.json["materials"][2]["normalTexture"]["index"] = file.appendTexture();
    file.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        file.floats("VEC2", {0, 0, 1, 0, 0, 1});
    const Scene scene = file.loaded();
    EXPECT_TRUE(scene.materials.at(2).textures[franken::TextureRole::Normal]);
    EXPECT_EQ(scene.meshes.at(0).primitives.at(0).tangents.size(), 3u);
}

TEST(GltfVariants, NamesThatCannotBeToldApartAreMended) {
    GltfFile file = fileWith({{{"material", 1}, {"variants", {0}}}},
                             {{{"name", "day"}}, {{"name", "day"}}, Json::object(), {{"name", "dusk"}}});
    EXPECT_EQ(file.loaded().variants, (std::vector<std::string>{"day", "day#1", "#2", "dusk"}));
    EXPECT_EQ(file.warnings.size(), 2u);
}

TEST(GltfVariants, AFaultyMappingCostsItselfAlone) {
    const Json good = {{"material", 1}, {"variants", {1}}};
    for (const Json& bad : {Json{{"material", 7}, {"variants", {0}}},
                            Json{{"material", 1}, {"variants", {9}}}, Json{{"variants", {0}}}}) {
        GltfFile file = fileWith({bad, good}, kDayAndNight);
        EXPECT_EQ(file.loaded().meshes.at(0).primitives.at(0).variantMaterials,
                  (std::vector<int>{kNone, 1, kNone}));
        ASSERT_EQ(file.warnings.size(), 1u) << bad;
        EXPECT_NE(file.warnings[0].find("/mappings/0"), std::string::npos) << file.warnings[0];
    }
    for (const Json& bad :
         {Json{{"material", "red"}, {"variants", {0}}}, Json(7), Json{{"variants", {-1}}}}) {
        GltfFile file = fileWith({bad, good}, kDayAndNight);
        const auto scene = file.load();
        EXPECT_TRUE(scene || scene.error().where.find("/mappings/0") != std::string::npos) << bad;
    }
}

TEST(GltfVariants, MoreOfThemThanThereIsMemoryIsRefused) {
    Json variants = Json::array(), mapping = {{"material", 1}, {"variants", Json::array()}};
    for (int i = 0; i < 2000; ++i) {
        variants.push_back({{"name", std::to_string(i)}});
        mapping["variants"].push_back(i);
    }
    GltfFile file = fileWith(Json::array({mapping}), variants);
    Json& primitives = file.json["meshes"][0]["primitives"];
    const Json first = primitives[0];
    for (int i = 0; i < 50; ++i)
        primitives.push_back(first);
    franken::LoadOptions options;
    options.maxMemoryBytes = 16 << 20;
    const auto scene = file.load(options);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, "gltf.limit");
}

} // namespace
