// SPDX-License-Identifier: MIT
// The viewer as a shell sees it.
#include "franken/generator/permutation.h"
#include "support/draw_scene.h"
#include "support/shell.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUrn = URN_GLB;

class Viewer : public testing::Test {
protected:
    Outcome run(const std::string& arguments) { return runIn(m_folder, VIEWER " " + arguments); }

    void SetUp() override {
        // OSMesa forgets a few hundred bytes with each context: for a viewer built with AddressSanitizer.
        const fs::path suppressions = m_folder / "leaks.txt";
        std::ofstream(suppressions) << "leak:libOSMesa\n";
        setenv("LSAN_OPTIONS", ("print_suppressions=0:suppressions=" + suppressions.string()).c_str(), 1);
        setenv("GALLIUM_DRIVER", "softpipe", 0);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    }

    const fs::path m_folder = emptyTestFolder();
};

TEST_F(Viewer, DrawsTheSamePictureOnBothBackends) {
    const std::string model = std::string(kUrn) + " --size 80x60 ";
    for (const std::string backend : {"osmesa", "egl"}) {
        const Outcome outcome = run(model + "--backend " + backend + " -o " + backend + ".png");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    const Picture osmesa = readPicture(m_folder / "osmesa.png");
    EXPECT_EQ(osmesa.width, 80);
    EXPECT_EQ(osmesa.height, 60);
    const Difference difference = compareLit(osmesa, readPicture(m_folder / "egl.png"));
    EXPECT_GT(difference.pixels, 300u);
    EXPECT_EQ(difference.max(), 0) << difference;
}

TEST_F(Viewer, SupersamplingMakesEdgesSoft) {
    const std::string model = std::string(kUrn) + " --size 80x60 ";
    EXPECT_EQ(run(model + "-o plain.png").code, 0);
    EXPECT_EQ(run(model + "-o soft.png --supersample").code, 0);
    const Picture soft = readPicture(m_folder / "soft.png");
    EXPECT_EQ(soft.width, 80);
    const Difference difference = compareLit(soft, readPicture(m_folder / "plain.png"));
    EXPECT_GT(difference.mean, 1);
    EXPECT_LT(std::abs(difference.bias), 4);
}

TEST_F(Viewer, PrintsThePermutationsThatItNeeds) {
    const Outcome outcome = run(std::string(kUrn) + " --permutations --brdf seed");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        const Result<Permutation> permutation = parseName(line);
        ASSERT_TRUE(permutation) << line;
        EXPECT_EQ(permutation->brdf, Brdf::Seed) << line;
    }
    EXPECT_GE(count, 1);
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
}

TEST_F(Viewer, HelpShowsAnExample) {
    const Outcome outcome = run("--help");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("Example: viewer"), std::string::npos);
}

TEST_F(Viewer, ExitCodesTellWhoseFaultItIs) {
    const std::string urn = kUrn;
    EXPECT_EQ(run("").code, 2);
    EXPECT_EQ(run(urn + " --size 0x5").code, 2);
    EXPECT_EQ(run(urn + " --size 9000x30").code, 2);
    EXPECT_EQ(run(urn + " --sun 0,0,0").code, 2);
    EXPECT_EQ(run(urn + " --sun 1,2:3").code, 2);
    EXPECT_EQ(run(urn + " --camera nobody").code, 2);
    EXPECT_EQ(run(urn + " --tone-map loud").code, 2);
    EXPECT_EQ(run(urn + " --sun 0,-1,0 --sun 0,-1,0 --sun 0,-1,0 --sun 0,-1,0 --sun 0,-1,0").code, 2);
    EXPECT_EQ(run("missing.gltf").code, 3);
    EXPECT_EQ(run(urn + " --skybox missing.hdr").code, 3);
    EXPECT_EQ(run(urn + " --size 40x30 -o no/such/folder.png").code, 4);
    EXPECT_NE(run("missing.gltf").err.find("missing.gltf"), std::string::npos);
}

/// A viewer in the background that watches a copy of the model and of the snippets.
class Watching : public Viewer {
protected:
    void SetUp() override {
        Viewer::SetUp();
        fs::create_directory(m_folder / "model");
        fs::copy(kUrn, m_folder / "model");
        fs::copy(fs::path(FRANKEN_SOURCE_DIR) / "generator/glsl", m_folder / "glsl",
                 fs::copy_options::recursive);
        m_snippet = readText(m_folder / "glsl/fragment/specular.glsl");
        m_viewer = fork();
        if (m_viewer == 0) {
            const std::string command = "cd " + m_folder.string() + " && exec " VIEWER " model/" +
                                        fs::path(kUrn).filename().string() +
                                        " --size 40x30 --snippets glsl --watch 2>err.txt";
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
    }

    void TearDown() override {
        kill(m_viewer, SIGTERM);
        int status = 0;
        waitpid(m_viewer, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status << "\n" << err();
    }

    std::string err() const { return readText(m_folder / "err.txt"); }

    /// Waits until the viewer has said so that often.
    void await(const std::string& message, int times) {
        using namespace std::chrono_literals;
        for (int i = 0; i < 1200; ++i, std::this_thread::sleep_for(50ms)) {
            int count = 0;
            const std::string said = err();
            for (std::size_t at = 0; (at = said.find(message, at)) != std::string::npos; ++at)
                ++count;
            if (count >= times)
                return;
        }
        FAIL() << message << " was not said " << times << " times in a minute:\n" << err();
    }

    void writeSnippet(const std::string& more) {
        std::ofstream(m_folder / "glsl/fragment/specular.glsl") << m_snippet << more;
    }

    pid_t m_viewer = 0;
    std::string m_snippet;
};

TEST_F(Watching, TakesASnippetAndKeepsTheLastGoodPicture) {
    const fs::path out = m_folder / "out.png";
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const Picture first = readPicture(out);

    writeSnippet("  specular += vec3(0.2, 0.0, 0.0);\n");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    const Picture redder = readPicture(out);
    const Difference difference = compareLit(redder, first);
    EXPECT_GT(difference.pixels, 100u);
    EXPECT_GT(difference.bias, 5) << difference;

    writeSnippet("  specular += nonsense;\n"); // Refused by the driver.
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 1));
    EXPECT_NE(err().find("generator/glsl/fragment/specular.glsl:4"), std::string::npos) << err();
    EXPECT_NE(err().find("nonsense"), std::string::npos) << err();
    EXPECT_EQ(readPicture(out).rgba, redder.rgba);

    writeSnippet("//! nonsense\n"); // Refused by the composer.
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 2));
    EXPECT_NE(err().find("[snippet.syntax]"), std::string::npos) << err();
    EXPECT_EQ(readPicture(out).rgba, redder.rgba);

    writeSnippet("");
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 3));
    EXPECT_EQ(readPicture(out).rgba, first.rgba);
}

TEST_F(Watching, TakesAModel) {
    const fs::path model = m_folder / "model" / fs::path(kUrn).filename();
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 1));
    const Picture urn = readPicture(m_folder / "out.png");

    std::ofstream(model) << "{}";
    ASSERT_NO_FATAL_FAILURE(await("viewer: kept the last good picture", 1));
    EXPECT_EQ(readPicture(m_folder / "out.png").rgba, urn.rgba);

    std::ofstream(model) << R"({"asset": {"version": "2.0"}})"; // Nothing at all.
    ASSERT_NO_FATAL_FAILURE(await("viewer: wrote out.png", 2));
    const Picture nothing = readPicture(m_folder / "out.png");
    EXPECT_EQ(compareLit(nothing, nothing).pixels, 0u);
}

TEST_F(Viewer, SnippetsOfItsOwnMustCompile) {
    fs::copy(fs::path(FRANKEN_SOURCE_DIR) / "generator/glsl", m_folder / "glsl", fs::copy_options::recursive);
    const std::string urn = std::string(kUrn) + " --size 40x30 --snippets glsl";
    EXPECT_EQ(run(urn).code, 0);
    std::ofstream(m_folder / "glsl/fragment/specular.glsl", std::ios::app) << "  specular += nonsense;\n";
    EXPECT_EQ(run(urn).code, 4);
    fs::remove(m_folder / "glsl/fragment/specular.glsl");
    EXPECT_EQ(run(urn).code, 3);
}

TEST_F(Viewer, DrawsUnderASkyByOthers) {
    const fs::path sky = findShared("assets/env/venice.hdr");
    if (sky.empty())
        GTEST_SKIP() << "needs ../shared/assets/env beside the sources";
    const Outcome outcome =
        run(std::string(kUrn) + " --size 80x60 --tone-map neutral --skybox " + sky.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Picture picture = readPicture(m_folder / "out.png");
    const std::uint8_t* const corner = picture.rgba.data(); // Sky, not background.
    EXPECT_GT(corner[0] + corner[1] + corner[2], 0);
    const std::string programs = run(std::string(kUrn) + " --permutations --skybox " + sky.string()).out;
    EXPECT_NE(programs.find("+sh+mirror"), std::string::npos) << programs;
}

} // namespace
} // namespace franken::test
