// SPDX-License-Identifier: MIT
#include "franken/generator/budget.h"
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"
#include "franken/generator/explain.h"
#include "franken/generator/pack.h"
#include "population.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace franken;
using test::named;

namespace {

Profile profile(std::string_view name) { return findProfile(name).value(); }

struct PackingRow {
    const char* what;
    std::vector<Type> varyings;
    int vectors;
};

// Worked by hand after appendix A.7 of the GLSL ES 1.00 specification.
const PackingRow kPacking[] = {
    {"nothing", {}, 0},
    {"a float", {Type::Float}, 1},
    {"four floats share a row", {Type::Float, Type::Float, Type::Float, Type::Float}, 1},
    {"two vec2 share a row", {Type::Vec2, Type::Vec2}, 1},
    {"three vec2 take two", {Type::Vec2, Type::Vec2, Type::Vec2}, 2},
    {"a float beside a vec3", {Type::Float, Type::Vec3}, 1},
    {"a vec2 fits beside no vec3", {Type::Vec2, Type::Vec3}, 2},
    {"two floats beside a vec2", {Type::Float, Type::Vec2, Type::Float}, 1},
    {"a mat3 leaves three floats", {Type::Float, Type::Mat3, Type::Float, Type::Float}, 3},
    {"a mat4 leaves nothing", {Type::Mat4, Type::Float}, 5},
    {"vec4, vec3 and float, vec2 and vec2", {Type::Vec2, Type::Vec4, Type::Float, Type::Vec3, Type::Vec2}, 3},
};

TEST(Budget, PacksVaryingsAsTheSpecificationDoes) {
    for (const PackingRow& row : kPacking) {
        Interface interface;
        for (const Type type : row.varyings)
            interface.varyings.push_back({"v", type});
        EXPECT_EQ(budget(interface, profile("vc4"))[Resource::Varyings].used, row.vectors) << row.what;
    }
}

TEST(Budget, ArraysStayTogether) {
    Interface interface;
    interface.uniforms = {{"coefficients", Type::Vec3, 9, Block::Lights, false, true},
                          {"weights", Type::Float, 9, Block::Lights, false, true},
                          {"pairs", Type::Vec2, 3, Block::Lights, true, true}};
    const Budget result = budget(interface, profile("vc4"));
    EXPECT_EQ(result[Resource::FragmentUniforms].used, 12)
        << "nine rows with the floats beside, three of pairs";
    EXPECT_EQ(result[Resource::VertexUniforms].used, 3) << "an array is not split over two columns";
}

TEST(Budget, CountsEachResourceOnItsOwn) {
    Interface interface;
    interface.attributes = {{"aPosition", Type::Vec3, 0}, {"aUv0", Type::Vec2, 3}};
    interface.samplers = {{"uNormalTexture", Type::Sampler2D, 1, Block::Material}};
    const Budget result = budget(interface, profile("es2-minimum"));
    EXPECT_EQ(result[Resource::Attributes].used, 2) << "attributes are never packed";
    EXPECT_EQ(result[Resource::Samplers].used, 1);
    EXPECT_EQ(result[Resource::Samplers].limit, 8);
    EXPECT_EQ(result[Resource::FragmentUniforms].limit, 16);
    EXPECT_TRUE(result.fits());
}

TEST(Budget, NamesTheRolesThatHaveNoUnit) {
    Interface interface;
    interface.samplers = {{"uNormalTexture", Type::Sampler2D, 1, Block::Material},
                          {"uOcclusionTexture", Type::Sampler2D, 8, Block::Material},
                          {"uEmissiveTexture", Type::Sampler2D, 9, Block::Material}};
    const Budget least = budget(interface, profile("es2-minimum"));
    EXPECT_EQ(least.rolesBeyond, (std::vector<std::string_view>{"occlusion", "emissive"}));
    EXPECT_FALSE(least.fits());
    EXPECT_FALSE(least[Resource::Samplers].exceeded()) << "three of eight";
    EXPECT_TRUE(budget(interface, profile("vc4")).fits());
}

TEST(Budget, LightsAreThoseOfThePlan) {
    for (const auto& [name, lights] : {std::pair("sun2+punctual3", 5),
                                       {"sun4", 4},
                                       {"normal+sun2+vertexlight", 2},
                                       {"sh+reflection+sun1+punctual1+spots", 2},
                                       {"sh", 0},
                                       {"sky", 0}})
        EXPECT_EQ(compose(named(name)).interface.lights, lights) << name;
}

// As their sources state them: what glGetIntegerv says with Mesa's drivers of the Pis (25.0.7), lima's tables
// of that Mesa (13 varyings less the position; 304 and 2,048 uniforms), the tables 6.19 and 6.20 of OpenGL ES
// 2.0.25, and what Debian 12's rasterisers say.
TEST(Budget, ProfilesHaveTheLimitsOfTheirSources) {
    const std::map<std::string_view, std::array<int, kResourceCount>> stated = {
        {"vc4", {8, 8, 4088, 4095, 16, 4}},
        {"v3d", {16, 16, 4096, 4095, 24, 8}},
        {"mali-400", {16, 13 - 1, 304, 2048, 16, 8}},
        {"es2-minimum", {8, 8, 128, 16, 8, 8}},
        {"software", {16, 32, 4096, 4096, 32, 8}}};
    EXPECT_EQ(profiles().size(), stated.size());
    for (const Profile& each : profiles()) {
        ASSERT_TRUE(stated.count(each.name)) << each.name << " has no source here";
        EXPECT_EQ(each.limits, stated.at(each.name)) << each.name;
    }
}

TEST(Budget, AProfileIsFoundByNameOrTheNamesAreOffered) {
    for (const Profile& each : profiles())
        EXPECT_EQ(findProfile(each.name)->name, each.name);
    const auto missing = findProfile("vc5");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, "budget.unknown-profile");
    EXPECT_NE(missing.error().remedy.find("es2-minimum"), std::string::npos);
}

TEST(Budget, TheCoveringSetFitsThePisButForManyLightsOnVc4) {
    for (const Permutation& permutation : coveringSet()) {
        const Budget mali = budget(compose(permutation).interface, profile("mali-400"));
        EXPECT_TRUE(mali.fits() ||
                    (permutation.joints == Joints::UpTo256 && mali[Resource::VertexUniforms].exceeded()))
            << toName(permutation);
        if (permutation.precision == Precision::Fp16)
            continue; // Both have 32 bits.
        const Budget vc4 = budget(compose(permutation).interface, profile("vc4"));
        const int lights = permutation.suns + permutation.punctualLights;
        EXPECT_TRUE(vc4.fits() || (lights > 4 && vc4[Resource::Lights].exceeded())) << toName(permutation);
        EXPECT_TRUE(budget(compose(permutation).interface, profile("v3d")).fits()) << toName(permutation);
    }
}

// What Capabilities::joints reckons with.
TEST(Budget, APaletteLeaves32VectorsForTheRest) {
    int most = 0;
    for (const Permutation& permutation : test::population())
        if (permutation.influences > 0) {
            const Budget used = budget(compose(permutation).interface, profile("v3d"));
            const int beside =
                used[Resource::VertexUniforms].used - 3 * static_cast<int>(roomFor(permutation.joints));
            most = std::max(most, beside);
            EXPECT_LE(beside, 32) << toName(permutation);
        }
    EXPECT_GT(most, 20) << "32 are too many";
}

// tests/qpu asks the compiler itself about hundreds of others.
TEST(Budget, OnVc4MoreLightsFitWhereLittleElseIsHeld) {
    struct Row {
        const char* name;
        int limit;
    };
    for (const auto& [name, limit] : {
             Row{"sun4+punctual4", 8},
             {"sun4+punctual4+spots", 8},
             {"basecolor.normal+sun4+punctual4", 8},
             {"basecolor.vertexcolor.metalrough+sun4+punctual4+spots", 6},
             {"basecolor.vertexcolor.metalrough-separate.normal.occlusion.emissive+sh+reflection+sun4+"
              "punctual4+spots",
              4},
             {"basecolor.vertexcolor.metalrough-separate.normal.occlusion.emissive+sh+reflection+sun2+"
              "punctual2",
              5},
         }) {
        const Interface interface = compose(named(name)).interface;
        EXPECT_EQ(budget(interface, profile("vc4"))[Resource::Lights].limit, limit) << name;
        EXPECT_EQ(budget(interface, profile("v3d"))[Resource::Lights].limit, 8) << name;
    }
}

TEST(Budget, NamesWhatToGiveUp) {
    const Permutation permutation = named("basecolor+sh+sun4+punctual4+spots");
    const Budget least = budget(compose(permutation).interface, profile("es2-minimum"));
    ASSERT_TRUE(least[Resource::FragmentUniforms].exceeded());
    const std::vector<Feature> features = costlyFeatures(permutation, Resource::FragmentUniforms);
    std::set<std::string> words;
    for (const Feature& feature : features) {
        words.insert(feature.word);
        EXPECT_LT(feature.used, least[Resource::FragmentUniforms].used) << feature.word;
    }
    EXPECT_TRUE(words.count("sh") && words.count("sun4") && words.count("spots"));
    EXPECT_FALSE(words.count("punctual4")) << "spots need punctual lights";
    EXPECT_TRUE(std::is_sorted(features.begin(), features.end(),
                               [](const Feature& a, const Feature& b) { return a.used < b.used; }));
}

TEST(Budget, WhatAFeatureIsSaidToLeaveIsWhatItLeaves) {
    const Budget without = budget(compose(named("normal+sun2")).interface, profile("vc4"));
    for (const Feature& feature : costlyFeatures(named("normal+sh+sun2"), Resource::FragmentUniforms)) {
        if (feature.word == "sh") {
            EXPECT_EQ(feature.used, without[Resource::FragmentUniforms].used);
        }
    }
}

std::string reasonOf(const Permutation& permutation, std::string_view snippet) {
    for (const Reason& reason : explain(permutation))
        if (reason.snippet == snippet)
            return toText(reason);
    return "no such snippet";
}

TEST(Explain, NamesTheWordsThatBroughtASnippet) {
    const Permutation permutation = named("basecolor+sun1+punctual1+spots+aces");
    EXPECT_EQ(reasonOf(permutation, "fragment/base_color/texture"), "basecolor");
    EXPECT_EQ(reasonOf(permutation, "fragment/lights/punctual.spot"), "punctual1+spots");
    EXPECT_EQ(reasonOf(permutation, "fragment/brdf/smith_correlated"), "sun1 or others");
    EXPECT_EQ(reasonOf(permutation, "fragment/output/tone_aces"), "aces");
    EXPECT_EQ(reasonOf(permutation, "vertex/transform/position"), "");
    EXPECT_EQ(reasonOf(named("basecolor+sun1+aces"), "fragment/brdf/smith_correlated"), "sun1");
}

TEST(Explain, LeavesNoSnippetOfThePopulationOut) {
    for (const Permutation& permutation : coveringSet()) {
        std::set<std::string, std::less<>> explained;
        for (const Reason& reason : explain(permutation))
            explained.insert(reason.snippet);
        const Composed program = compose(permutation);
        for (const ComposedStage* stage : {&program.vertex, &program.fragment})
            for (const LineOrigin& line : stage->lines)
                EXPECT_TRUE(line.snippet.empty() || explained.count(line.snippet)) << line.snippet;
    }
}

} // namespace
