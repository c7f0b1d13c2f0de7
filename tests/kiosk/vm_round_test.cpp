// SPDX-License-Identifier: MIT
// Twenty models in turn, some of them broken, for thousands of frames: none is late, nothing is compiled and
// nothing grows after the first round. In virtual time.
#include "franken/file.h"
#include "franken/image.h"
#include "kiosk/vm_kiosk.h"
#include "support/shell.h"

#include <cstdlib>
#include <thread>

namespace franken::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string kBoxFolder = kModels + "BoxTextured-glTF/";
const std::string kCubeFolder = kModels + "glTF-Sample-Models/AnimatedMorphCube-glTF/";
const std::string kContent = "[content]\nplaylist = [\"first.glb\"]\nfolder = \"models\"\n";
const std::string kChanging = kContent + "seconds = 1\nfade-seconds = 0.2\n";
const std::string kStaying = kContent + "seconds = 0\n[show]\nturn-seconds = 0\n";
constexpr int kFrames = 2000;

class KioskRound : public KioskInGuest {
protected:
    void SetUp() override {
        KioskInGuest::SetUp();
        if (IsSkipped())
            return;
        setenv("SOFTPIPE_DEBUG", "vs,fs",
               1); // Each shader that Mesa's driver makes is told on standard error.
        fs::copy_file(kBox, folder() / "first.glb");
        for (char letter = 'a'; letter < 'q'; ++letter) // The engine has many triangles for softpipe.
            copyModel(letter == 'd' || letter == 'k' ? kEngine : kBox, std::string{letter} + ".glb");
        fs::copy(kCubeFolder, models() / "cube");
        fs::copy(kBoxFolder, models() / "bare");
        fs::remove(models() / "bare/CesiumLogoFlat.png");
        std::ofstream(models() / "broken.glb") << readText(kBox).substr(0, 2000);
    }
    void TearDown() override {
        unsetenv("SOFTPIPE_DEBUG");
        KioskInGuest::TearDown();
    }

    /// Waits until the first model is shown again, and stays there for new statistics.
    std::string statisticsOfTheFirst() {
        EXPECT_TRUE(logs("shows " + (folder() / "first.glb").string(), 60));
        writeConfig(kStaying);
        EXPECT_TRUE(logs("the configuration was read again"));
        std::this_thread::sleep_for(2s);
        std::string all = metrics();
        m_shaders = shadersOfMesa();
        writeConfig(kChanging);
        EXPECT_TRUE(logs("the configuration was read again"));
        return all;
    }

    int shadersOfMesa() const {
        std::istringstream lines(log());
        int shaders = 0;
        for (std::string line; std::getline(lines, line);)
            shaders += line == "FRAG" || line == "VERT" ? 1 : 0;
        return shaders;
    }

    /// Shows that model alone, and compares a screenshot with a picture that `kiosk --frame` draws.
    void expectRight(const std::string& model) {
        SCOPED_TRACE(model);
        writeConfig("[content]\nplaylist = [\"" + model +
                    "\"]\nseconds = 0\n[show]\nturn-seconds = 0\nanimations = false\npixel-shift = 0\n");
        ASSERT_TRUE(logs("shows " + (folder() / model).string()));
        std::this_thread::sleep_for(2s);
        const VmPicture shown = picture("kiosk_round_" + fs::path(model).stem().string());
        const Outcome drawn =
            runIn(folder(), KIOSK " --config kiosk.toml --frame frame.png --size 160x120 2>frame.log");
        ASSERT_EQ(drawn.code, 0) << readText(folder() / "frame.log");
        const auto bytes = franken::readFile(folder() / "frame.png", 1 << 20);
        ASSERT_TRUE(bytes);
        const auto image = decodeImage(*bytes);
        ASSERT_TRUE(image);
        ASSERT_EQ(shown.pixels.size() * 4, image->rgba.size());
        std::size_t wrong = 0;
        for (std::size_t at = 0; at < shown.pixels.size(); ++at)
            for (std::size_t channel = 0; channel < 3; ++channel)
                wrong +=
                    (shown.pixels[at] >> (16 - 8 * channel) & 0xFF) != image->rgba[4 * at + channel] ? 1 : 0;
        EXPECT_EQ(wrong, 0U);
        EXPECT_GT(brightShare(shown), 0.05);
    }

    int m_shaders = 0; ///< That Mesa had made, at the last statistics.
};

TEST_F(KioskRound, TwentyModelsForTwoThousandFramesWithoutALateOne) {
    start(kChanging);
    ASSERT_TRUE(logs("shows " + (folder() / "first.glb").string()));
    std::ofstream half(models() / "half.glb"); // Is being copied for all of the time.
    half << readText(kBox).substr(0, 3000) << std::flush;
    const std::string before = statisticsOfTheFirst();
    const int shaders = m_shaders;
    EXPECT_GT(shaders, 0) << "Mesa does not tell what it makes";
    EXPECT_EQ(valueOf("models", before), 20);
    const double first = valueOf("frame_duration_seconds_count", before);
    std::string after = before;
    while (valueOf("frame_duration_seconds_count", after) - first < kFrames && !HasFailure())
        after = statisticsOfTheFirst();
    EXPECT_EQ(valueOf("late_frames_total", after), 0);
    EXPECT_GT(valueOf("models_shown_total", after), 60);
    EXPECT_EQ(valueOf("shader_compiles_total", after), valueOf("shader_compiles_total", before));
    EXPECT_EQ(m_shaders, shaders);
    EXPECT_EQ(valueOf("gpu_memory_bytes", after), valueOf("gpu_memory_bytes", before));
    EXPECT_LT(valueOf("resident_memory_bytes", after), valueOf("resident_memory_bytes", before) + (1 << 20));
    EXPECT_EQ(log().find("half.glb"), std::string::npos) << "it was not complete";
    EXPECT_NE(log().find("broken.glb is skipped"), std::string::npos);
    EXPECT_NE(log().find("CesiumLogoFlat.png"), std::string::npos) << "a missing texture is told";
    for (const char* model : {"models/d.glb", "models/bare/BoxTextured.gltf", "models/e.glb"})
        expectRight(model);
}

} // namespace
} // namespace franken::test
