// SPDX-License-Identifier: MIT
// What the kiosk shows, and what it does with models that come, go and break. In virtual time.
#include "kiosk/vm_kiosk.h"
#include "support/shell.h"

#include <csignal>
#include <thread>

namespace franken::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class KioskShow : public KioskInGuest {};

TEST_F(KioskShow, ModelsOfAWatchedFolderComeAndGo) {
    start("[content]\nfolder = \"models\"\nseconds = 2\n");
    ASSERT_TRUE(logs("drawing"));
    EXPECT_LT(brightShare(picture("kiosk_empty")), 0.05);
    copyModel(kBox, "a.glb");
    ASSERT_TRUE(logs("shows " + (models() / "a.glb").string()));
    std::this_thread::sleep_for(1s);
    const VmPicture box = picture("kiosk_turning");
    EXPECT_GT(brightShare(box), 0.1);
    std::this_thread::sleep_for(1s);
    EXPECT_FALSE(picture("kiosk_turned") == box) << "it does not turn";
    copyModel(kEngine, ".b.glb.part");
    fs::rename(models() / ".b.glb.part", models() / "b.glb");
    ASSERT_TRUE(logs("shows " + (models() / "b.glb").string()));
    ASSERT_TRUE(logs("shows " + (models() / "a.glb").string()));
    fs::remove(models() / "a.glb");
    ASSERT_TRUE(logs("shows " + (models() / "b.glb").string()));
    std::this_thread::sleep_for(3s);
    EXPECT_FALSE(logs("shows", 1)) << "nothing else is there to be shown";
    EXPECT_TRUE(kiosk().runs());
}

TEST_F(KioskShow, TwentyModelsOfWhichThreeAreHarmed) {
    for (int i = 0; i < 20; ++i) {
        const std::string name = "m" + std::to_string(10 + i) + ".glb";
        if (i == 3)
            std::ofstream(models() / name) << "this is no model";
        else if (i == 7)
            std::ofstream(models() / name) << readText(kBox).substr(0, 3000);
        else
            copyModel(i == 5 ? kEngine : kBox, name);
    }
    fs::create_directory(models() / "n"); // Its texture is missing.
    fs::copy_file(kModels + "BoxTextured-glTF/BoxTextured.gltf", models() / "n/box.gltf");
    fs::copy_file(kModels + "BoxTextured-glTF/BoxTextured0.bin", models() / "n/BoxTextured0.bin");
    start("[content]\nfolder = \"models\"\nseconds = 1\nfade-seconds = 0.2\n");
    const auto round = [this] {
        EXPECT_TRUE(logs("n/box.gltf", 60));
        EXPECT_TRUE(logs("shows " + (models() / "m10.glb").string()));
    };
    round();
    std::this_thread::sleep_for(16s); // The statistics of the first round.
    const double compiles = metric("shader_compiles_total"), late = metric("late_frames_total");
    const double gpu = metric("gpu_memory_bytes"), resident = metric("resident_memory_bytes");
    round();
    round();
    EXPECT_EQ(metric("shader_compiles_total"), compiles) << "something is compiled after the first round";
    EXPECT_EQ(metric("late_frames_total"), late);
    EXPECT_LT(metric("gpu_memory_bytes"), gpu + (4 << 20));
    EXPECT_LT(metric("resident_memory_bytes"), resident + (4 << 20));
    EXPECT_EQ(metric("models_broken"), 2);
    EXPECT_GT(metric("frame_duration_seconds_count"), 1500);
    EXPECT_NE(log().find("m13.glb is skipped"), std::string::npos);
    EXPECT_NE(log().find("m17.glb is skipped"), std::string::npos);
}

TEST_F(KioskShow, ScreenshotsAndTheListOfProgramsOutliveAKill) {
    copyModel(kBox, "a.glb");
    start("[content]\nfolder = \"models\"\n");
    ASSERT_TRUE(logs("shows"));
    std::this_thread::sleep_for(1s);
    kiosk().signal(SIGUSR1);
    ASSERT_TRUE(logs("screenshot: "));
    fs::copy_file(folder() / "state/screenshot.png",
                  fs::path(getenv("GUEST_FOLDER")) / "kiosk_screenshot.png",
                  fs::copy_options::overwrite_existing);
    const std::string manifest = readText(folder() / "state/programs.manifest");
    EXPECT_NE(manifest.find("# end"), std::string::npos) << manifest;
    kiosk().signal(SIGKILL);
    kiosk().wait();
    start("[content]\nfolder = \"models\"\n");
    ASSERT_TRUE(logs("shows"));
    EXPECT_EQ(readText(folder() / "state/programs.manifest"), manifest);
    kiosk().signal(SIGTERM);
    EXPECT_EQ(kiosk().wait(), 0);
}

TEST_F(KioskShow, AChangedConfigurationTakesEffectAndABadOneDoesNot) {
    copyModel(kBox, "a.glb");
    start("[content]\nfolder = \"models\"\n[show]\nturn-seconds = 0\n");
    ASSERT_TRUE(logs("shows"));
    std::this_thread::sleep_for(2s);
    const VmPicture before = picture("kiosk_before");
    writeConfig("[content]\nfolder = \"models\"\n[show]\nturn-seconds = 0\nbackground = \"0.5,0,0\"\n");
    ASSERT_TRUE(logs("the configuration was read again"));
    std::this_thread::sleep_for(1s);
    const VmPicture red = picture("kiosk_red");
    EXPECT_EQ(red.at(0, 0), 0x800000U);
    writeConfig("[content]\nfoldr = \"models\"\n");
    ASSERT_TRUE(logs("content.folder was probably meant"));
    ASSERT_TRUE(logs("the configuration stays as it was"));
    EXPECT_TRUE(picture("kiosk_still_red") == red);
    writeConfig("[content]\nfolder = \"models\"\n[show]\nturn-seconds = 0\n");
    ASSERT_TRUE(logs("the configuration was read again"));
    std::this_thread::sleep_for(1s);
    EXPECT_TRUE(picture("kiosk_again") == before);
}

} // namespace
} // namespace franken::test
