// SPDX-License-Identifier: MIT
// Programs from snippets that are read while the program runs.
#include "franken/snippet_folder.h"
#include "support/draw_scene.h"
#include "support/shapes.h"
#include "support/shell.h"

namespace franken::test {
namespace {

namespace fs = std::filesystem;

/// A copy of the snippets in which `ambient/none`, where the sum of all light begins, has one more line.
Result<SnippetSet> snippetsWith(const std::string& line) {
    const fs::path folder = emptyTestFolder();
    fs::copy(fs::path(FRANKEN_SOURCE_DIR) / "generator/glsl", folder, fs::copy_options::recursive);
    std::ofstream(folder / "fragment/ambient/none.glsl", std::ios::app) << line << "\n";
    return readSnippets(folder);
}

class SnippetsTest : public PictureTest {};

INSTANTIATE_TEST_SUITE_P(Backends, SnippetsTest, allBackends(), backendName);

TEST_P(SnippetsTest, ARendererDrawsWithOthersAndWithItsOwnAgain) {
    SceneBuilder builder;
    builder.add(square(), builder.addMaterial({}));
    builder.addSun({0, 0, -1}, {1, 1, 1}, 0.1f);
    const Camera camera = framingCamera(builder.scene.bounds(), 1);
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(builder.scene));
    renderer.setLighting(lightingOf(builder.scene));
    const auto middle = [&] {
        EXPECT_TRUE(renderer.draw(viewpointOf(camera, 1), {surface().framebuffer(), 64, 64}));
        return readBack().pixel(32, 32);
    };
    const auto before = middle();

    const Result<SnippetSet> brighter = snippetsWith("  sum.diffuse += vec3(0.25, 0.0, 0.0);");
    ASSERT_TRUE(brighter) << toString(brighter.error());
    renderer.setSnippets(*brighter);
    const auto during = middle();
    EXPECT_GT(during[0], before[0] + 50);
    EXPECT_EQ(during[1], before[1]);

    renderer.setSnippets(SnippetSet::builtIn());
    EXPECT_EQ(middle(), before);
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(SnippetsTest, ACacheSaysInWhichSnippetTheErrorIs) {
    const Result<SnippetSet> broken = snippetsWith("  sum.diffuse = nonsense;");
    ASSERT_TRUE(broken) << toString(broken.error());
    ProgramCache cache(gl());
    const Permutation permutation = canonicalise(*parseName("sun1"))->permutation;
    const Result<ProgramHandle> working = cache.get(permutation);
    ASSERT_TRUE(working);
    cache.setSnippets(*broken);
    const Result<ProgramHandle> failed = cache.get(permutation);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, "program.compile");
    EXPECT_NE(failed.error().what.find("fragment/ambient/none.glsl:"), std::string::npos)
        << failed.error().what;
    EXPECT_TRUE(gl().IsProgram((*working)->name())) << "whoever holds a program keeps it";
}

} // namespace
} // namespace franken::test
