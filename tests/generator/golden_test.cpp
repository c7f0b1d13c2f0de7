// SPDX-License-Identifier: MIT
// The text of some programs, byte by byte. A golden is written by the target `update-goldens` alone, and
// then read by a person in the diff of the commit.
#include "franken/generator/choices.h"
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"
#include "population.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace franken {
namespace {

using namespace test;
namespace fs = std::filesystem;

struct Golden {
    std::string_view file, name;
};

constexpr Golden kGoldens[] = {
    {"seed_page", "basecolor.normal+ambient+sun1+seed+decode-none+linear"},
    {"surface", "surface"},
    {"sky", "sky"},
    {"sky_aces_dithered", "sky+aces+srgb-fast+dither"},
    {"overlay", "overlay+basecolor.blend"},
    {"overlay_vertex_color", "overlay+vertexcolor"},
    {"overlay_linear", "overlay+basecolor+linear"},
    {"unlit", "basecolor.unlit"},
    {"unlit_masked", "basecolor.vertexcolor.mask.basecolor-uv1.uv1-transform.unlit+pow22"},
    {"factors_gltf", "sun1"},
    {"factors_seed", "sun1+seed"},
    {"factors_fast", "sun1+fast"},
    {"factors_schlick", "sun1+schlick"},
    {"packed_gltf", "basecolor.metalrough+sun2"},
    {"packed_seed", "basecolor.metalrough+sun2+seed"},
    {"packed_fast", "basecolor.metalrough+sun2+fast"},
    {"packed_schlick", "basecolor.metalrough+sun2+schlick"},
    {"packed_vc4", "basecolor.metalrough+sun1+vc4"},
    {"separate", "basecolor.metalrough-separate+ambient+sun1"},
    {"separate_on_uv1", "metalrough-separate.metalrough-uv1.uv1-transform+sun1+fast"},
    {"damaged_helmet", "basecolor.metalrough.normal.occlusion.emissive+sh+sun1"},
    {"water_bottle", "basecolor.metalrough.normal.occlusion-packed.emissive+ambient+sun1+lamp1"},
    {"four_suns", "basecolor.normal+sun4"},
    {"three_suns_double", "basecolor.normal.double+ambient+sun3"},
    {"four_lamps", "basecolor+lamp4"},
    {"three_lamps", "basecolor+lamp3+reinhard"},
    {"spots", "basecolor.normal+lamp2+spots"},
    {"suns_and_spots", "basecolor.metalrough.normal+sh+sun2+lamp2+spots+neutral+dither"},
    {"vertex_light", "basecolor+ambient+sun1+vertexlight"},
    {"vertex_light_four", "basecolor.metalrough+sun4+vertexlight+fast"},
    {"vertex_light_tangent", "basecolor.metalrough.normal+ambient+sun1+vertexlight+fast"},
    {"vertex_light_tangent_two", "basecolor.metalrough.normal.double+sun2+vertexlight"},
    {"vertex_light_sky", "basecolor.normal+sh+sun2+vertexlight"},
    {"sky_alone", "basecolor+sh"},
    {"sky_alone_packed", "basecolor.metalrough.occlusion-packed+sh"},
    {"ambient_alone", "basecolor.occlusion+ambient+aces"},
    {"ambient_black", "emissive-factor"},
    {"emissive", "emissive.emissive-uv1.uv1-transform+reinhard"},
    {"emissive_fast", "basecolor.emissive+ambient+sun1+decode-fast+srgb-fast"},
    {"blend_fast", "basecolor.blend+sun1+decode-fast"},
    {"emissive_linear", "basecolor.emissive+ambient+sun1+decode-none"},
    {"mask_black", "basecolor.mask"},
    {"blend_lit", "basecolor.vertexcolor.blend+ambient+sun1+pow22"},
    {"double_sided", "basecolor.double+ambient+sun1"},
    {"double_sided_facing", "basecolor.normal.double+sun1+workaround-facing"},
    {"both_streams", "basecolor.metalrough.normal.occlusion.emissive.metalrough-uv1.normal-uv1.occlusion-uv1."
                     "uv0-transform.uv1-transform+ambient+sun1"},
    {"stream_1", "basecolor.occlusion.emissive.basecolor-uv1.occlusion-uv1.emissive-uv1+sh+sun1"},
    {"view_normal", "normal.double+view-normal"},
    {"view_normal_facing", "double+view-normal+workaround-facing"},
    {"view_metalrough", "metalrough-separate+view-metalrough"},
    {"view_metalrough_factors", "view-metalrough"},
    {"view_occlusion", "occlusion+dither+view-occlusion"},
    {"view_unoccluded", "view-occlusion"},
    {"everything", "basecolor.vertexcolor.metalrough.normal.occlusion-packed.emissive.mask.double+sh+sun2+"
                   "lamp2+spots+aces+srgb-fast+dither"},
};

const fs::path kFolder = FRANKEN_SOURCE_DIR "/tests/golden/text";
const std::string kHowTo = "\nrun 'cmake --build <build tree> --target update-goldens' and read the diff";

bool updating() { return std::getenv("FRANKEN_UPDATE_GOLDENS") != nullptr; }

std::string fileName(const Golden& golden, Stage stage) {
    return std::string(golden.file) + (stage == Stage::Vertex ? ".vert" : ".frag");
}

std::string firstDifference(const std::string& expected, const std::string& actual) {
    std::istringstream expectedLines(expected), actualLines(actual);
    std::string a, b;
    for (int line = 1;; ++line) {
        const bool more = !!std::getline(expectedLines, a);
        const bool moreToo = !!std::getline(actualLines, b);
        if (!more || !moreToo || a != b)
            return "first in line " + std::to_string(line) + ":\n-" + (more ? a : "(the end)") + "\n+" +
                   (moreToo ? b : "(the end)");
    }
}

void check(const fs::path& path, const std::string& text) {
    if (updating()) {
        std::ofstream(path, std::ios::binary) << text;
        return;
    }
    std::ifstream file(path, std::ios::binary);
    ASSERT_TRUE(file) << path << " is missing" << kHowTo;
    const std::string expected{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(text == expected) << path << " differs, " << firstDifference(expected, text) << kHowTo;
}

TEST(Golden, TextsAreTheSameToTheByte) {
    for (const Golden& golden : kGoldens) {
        const Composed program = compose(named(golden.name));
        check(kFolder / fileName(golden, Stage::Vertex), program.vertex.text);
        check(kFolder / fileName(golden, Stage::Fragment), program.fragment.text);
    }
}

TEST(Golden, NoFileIsLeftOver) {
    std::set<std::string> expected;
    for (const Golden& golden : kGoldens) {
        expected.insert(fileName(golden, Stage::Vertex));
        expected.insert(fileName(golden, Stage::Fragment));
    }
    EXPECT_EQ(expected.size(), 2 * std::size(kGoldens)) << "two goldens have one name";
    for (const auto& entry : fs::directory_iterator(kFolder))
        if (expected.count(entry.path().filename().string()) == 0) {
            if (updating())
                fs::remove(entry.path());
            else
                ADD_FAILURE() << entry.path() << " belongs to no golden" << kHowTo;
        }
}

TEST(Golden, NamesAreCanonical) {
    std::set<std::string_view> names;
    for (const Golden& golden : kGoldens) {
        EXPECT_EQ(toName(named(golden.name)), golden.name);
        EXPECT_TRUE(names.insert(golden.name).second) << golden.name << " stands twice";
    }
    EXPECT_GE(names.size(), 40u);
}

TEST(Golden, UseEverySnippet) {
    std::set<std::string> used;
    for (const Golden& golden : kGoldens) {
        const Composed program = compose(named(golden.name));
        for (const ComposedStage* stage : {&program.vertex, &program.fragment})
            for (const LineOrigin& origin : stage->lines)
                used.insert(std::string(origin.snippet) + ".glsl");
    }
    const fs::path folder = FRANKEN_SOURCE_DIR "/generator/glsl";
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".glsl") {
            EXPECT_EQ(used.count(fs::relative(entry.path(), folder).generic_string()), 1u) << entry.path();
        }
}

// ... that any program shows: what changes no program today, covering_test.cpp prints.
TEST(Golden, UseEveryOption) {
    const std::vector<Permutation> programs = coveringSet();
    for (const Choice& choice : choices()) {
        std::set<unsigned> possible, used;
        for (const Permutation& p : programs)
            possible.insert(choice.get(p));
        for (const Golden& golden : kGoldens)
            used.insert(choice.get(named(golden.name)));
        for (const unsigned value : possible)
            EXPECT_EQ(used.count(value), 1u) << choice.options[value].word;
    }
}

} // namespace
} // namespace franken
