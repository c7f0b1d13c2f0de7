// SPDX-License-Identifier: MIT
// The program `bake` as a shell sees it.
#include "franken/baked_sky.h"
#include "support/shell.h"

#include <array>
#include <cstdlib>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

class Bake : public testing::Test {
protected:
    int run(const std::string& arguments) const { return runIn(m_folder, BAKE " " + arguments).code; }

    /// 64 x 32 texels of one radiance, (2, 1, 0.5), and one bright texel ahead, a bit up.
    void writeSky(const std::string& name) const {
        std::ofstream file(m_folder / name, std::ios::binary);
        file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
        for (int i = 0; i < 64 * 32; ++i) {
            const char sun[] = {static_cast<char>(200), static_cast<char>(200), static_cast<char>(200),
                                static_cast<char>(140)};
            const char plain[] = {static_cast<char>(128), 64, 32, static_cast<char>(130)};
            file.write(i == 10 * 64 + 32 ? sun : plain, 4);
        }
    }

    const fs::path m_folder = emptyTestFolder();
};

TEST_F(Bake, MakesOfASkyWhatTheRuntimeReads) {
    writeSky("flat.hdr");
    ASSERT_EQ(run("flat.hdr --sun --skybox-size 16"), 0);
    const auto baked = loadSky(m_folder / "flat.sky");
    ASSERT_TRUE(baked) << toString(baked.error());
    EXPECT_EQ(baked->skybox.size, 16);
    EXPECT_EQ(baked->reflection.atlas.image.width, 2 * kReflectionSize);
    ASSERT_TRUE(baked->sun);
    EXPECT_GT(baked->sun->direction[2], 0.5f) << "it shines from ahead";
    EXPECT_LT(baked->sun->direction[1], 0) << "and from above";
    // 2 sqrt(pi) times the mean: of the plain texels, and of 32 times the mean (4.1) on one of 1,560.
    for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(baked->coefficients[0][channel],
                    3.5449f * (std::array{2.0f, 1.0f, 0.5f}[channel] + 32 * 4.1f / 1560), 0.02f);

    // The same as without the file.
    const auto direct = loadSky(m_folder / "flat.hdr", {.sun = true, .skyboxSize = 16});
    ASSERT_TRUE(direct);
    EXPECT_EQ(encodeBakedSky(*direct), encodeBakedSky(*baked));
}

/// The demonstration's sky: a sun to the left of what is ahead, and as bright as daylight indoors.
TEST_F(Bake, MakeModelWritesASky) {
    ASSERT_EQ(std::system((MAKE_MODEL " " + (m_folder / "lake.hdr").string() + " 1024").c_str()), 0);
    auto sky = loadEnvironment(m_folder / "lake.hdr");
    ASSERT_TRUE(sky) << toString(sky.error());
    EXPECT_EQ(sky->width, 1024);
    const auto sun = takeSun(*sky);
    ASSERT_TRUE(sun);
    EXPECT_GT(sun->direction[0], 0.7f);
    EXPECT_GT(sun->direction[2], 0.3f);
    EXPECT_LT(sun->direction[1], -0.1f);
    const Float3 mean = skyCoefficients(*sky)[0];
    EXPECT_GT(mean[1] / 3.5449f, 0.1f);
    EXPECT_LT(mean[1] / 3.5449f, 1);
}

TEST_F(Bake, ExitCodesTellWhoseFaultItIs) {
    writeSky("flat.hdr");
    EXPECT_EQ(run("--help"), 0);
    EXPECT_EQ(run(""), 2);
    EXPECT_EQ(run("flat.hdr --size 100"), 2);
    EXPECT_EQ(run("flat.hdr --skybox-size 4096"), 2);
    EXPECT_EQ(run("missing.hdr"), 3);
    std::ofstream(m_folder / "broken.hdr") << "#?RADIANCE";
    EXPECT_EQ(run("broken.hdr"), 3);
    EXPECT_EQ(run("flat.hdr --skybox-size 0 -o no/such/folder.sky"), 4);
}

TEST_F(Bake, DestroysNeitherItsSourceNorAGoodSky) {
    writeSky("flat.hdr");
    const std::string source = readText(m_folder / "flat.hdr");
    fs::create_symlink("flat.hdr", m_folder / "link.hdr");
    EXPECT_EQ(run("flat.hdr -o flat.hdr"), 2);
    EXPECT_EQ(run("flat.hdr -o link.hdr"), 2);
    EXPECT_EQ(readText(m_folder / "flat.hdr"), source);
    ASSERT_EQ(run("flat.hdr --skybox-size 16"), 0);
    const std::string good = readText(m_folder / "flat.sky");
    const Outcome full = runIn(m_folder, "trap '' XFSZ; ulimit -f 8; " BAKE " flat.hdr --skybox-size 32");
    EXPECT_EQ(full.code, 4) << full.err;
    EXPECT_EQ(readText(m_folder / "flat.sky"), good);
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(m_folder))
        files += entry.path().extension() == ".new";
    EXPECT_EQ(files, 0u) << "no temporary file is left";
}

TEST_F(Bake, ABakedSkyIsNotBakedAgain) {
    writeSky("flat.hdr");
    ASSERT_EQ(run("flat.hdr --skybox-size 16"), 0);
    const Outcome again = runIn(m_folder, BAKE " flat.sky -o again.sky");
    EXPECT_EQ(again.code, 3);
    EXPECT_NE(again.err.find("it is baked already"), std::string::npos) << again.err;
    EXPECT_EQ(again.err.find("PNG"), std::string::npos);
}

} // namespace
} // namespace franken::test
