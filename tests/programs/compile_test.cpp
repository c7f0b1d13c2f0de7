// SPDX-License-Identifier: MIT
// Programs in the thousands: each compiles and links.
#include "franken/generator/manifest.h"
#include "franken/gltf.h"
#include "generator/population.h"
#include "support/draw_scene.h"
#include "support/shell.h"

#include <map>

namespace franken::test {
namespace {

using CompileTest = OffscreenTest;

INSTANTIATE_TEST_SUITE_P(Backends, CompileTest, allBackends(), backendName);

/// Both backends run the same compiler of Mesa's: OSMesa gets all, EGL a part.
std::size_t stepFor(platform::Backend backend) { return backend == platform::Backend::OsMesa ? 1 : 10; }

void compileAll(const Gl& gl, const std::vector<Permutation>& permutations, const std::string& what,
                std::size_t step = 1) {
    ProgramCache cache(gl);
    std::size_t count = 0;
    for (std::size_t i = 0; i < permutations.size(); i += step, ++count) {
        const Result<ProgramHandle> program = cache.get(permutations[i]);
        ASSERT_TRUE(program) << toString(program.error());
    }
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    std::cout << what << ": " << count << " programs linked from " << cache.counters().compiles
              << " shaders\n";
}

TEST_P(CompileTest, ThePopulationCompilesAndLinks) {
    compileAll(gl(), population(), "population", stepFor(GetParam()));
}

TEST_P(CompileTest, TheNamedPermutationsCompileAndLink) {
    const std::string manifest = readText(FRANKEN_SOURCE_DIR "/tests/golden/named.manifest");
    std::vector<Permutation> permutations;
    for (const ManifestLine& line : manifestLines(manifest))
        permutations.push_back(named(line.name));
    EXPECT_GE(permutations.size(), 40u);
    compileAll(gl(), permutations, "named");
}

/// What the light may be where a file is drawn.
std::vector<Lighting> lightings(const Scene& scene) {
    Lighting own = lightingOf(scene);
    own.ambient.kind = Ambient::Color;
    Lighting sky;
    sky.ambient.kind = Ambient::Sky;
    sky.suns.resize(2);
    return {own, sky};
}

TEST_P(CompileTest, TheMaterialsOfRealFilesCompileAndLink) {
    const std::filesystem::path folder = findShared("assets/valid");
    if (folder.empty())
        GTEST_SKIP() << "needs ../shared/assets/valid beside the sources";
    std::map<Key, Permutation> needed;
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb")
            continue;
        const Result<Scene> scene = loadGltf(entry.path());
        if (!scene)
            continue; // The loader's own tests say which may be refused.
        ++files;
        for (const Lighting& lighting : lightings(*scene)) {
            const Result<std::vector<ProgramUse>> found = usesOf(*scene, lighting, {});
            ASSERT_TRUE(found) << entry.path() << ": " << toString(found.error());
            for (const ProgramUse& use : *found)
                needed.emplace(toKey(use.permutation), use.permutation);
        }
    }
    EXPECT_GE(files, 100);
    std::vector<Permutation> permutations;
    for (const auto& [key, permutation] : needed)
        permutations.push_back(permutation);
    compileAll(gl(), permutations, std::to_string(files) + " files");
}

} // namespace
} // namespace franken::test
