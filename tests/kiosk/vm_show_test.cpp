// SPDX-License-Identifier: MIT
// What the kiosk shows, and what it does with models that come, go and break. In virtual time.
#include "kiosk/vm_kiosk.h"
#include "support/shell.h"

#include <sys/mount.h>

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
    const VmPicture box = scanned("kiosk_turning");
    EXPECT_GT(brightShare(box), 0.1);
    std::this_thread::sleep_for(1s);
    EXPECT_FALSE(scanned("kiosk_turned") == box) << "it does not turn";
    copyModel(kEngine, ".b.glb.part");
    fs::rename(models() / ".b.glb.part", models() / "b.glb");
    ASSERT_TRUE(logs("shows " + (models() / "b.glb").string()));
    ASSERT_TRUE(logs("shows " + (models() / "a.glb").string()));
    fs::remove(models() / "a.glb");
    ASSERT_TRUE(logs("shows " + (models() / "b.glb").string()));
    std::this_thread::sleep_for(3s);
    EXPECT_FALSE(logs("shows", 1)) << "nothing else is there to be shown";
    fs::remove(models() / "b.glb");
    ASSERT_TRUE(logs("shows nothing"));
    std::this_thread::sleep_for(1s);
    EXPECT_LT(brightShare(picture("kiosk_gone")), 0.05) << "a model that was removed is still to be seen";
    copyModel(kEngine, "b.glb");
    ASSERT_TRUE(logs("shows " + (models() / "b.glb").string()));
    EXPECT_TRUE(kiosk().runs());
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

TEST_F(KioskShow, AFullOrReadOnlyDiskCostsTheFileAndNothingElse) {
    fs::create_directories(folder() / "state");
    const std::string state = (folder() / "state").string();
    ASSERT_EQ(mount("none", state.c_str(), "tmpfs", 0, "size=4k"), 0);
    std::ofstream(folder() / "state/full") << std::string(8192, 'x');
    copyModel(kBox, "a.glb");
    start("[content]\nfolder = \"models\"\nseconds = 1\nfade-seconds = 0\n");
    ASSERT_TRUE(logs("the list of programs is not kept"));
    kiosk().signal(SIGUSR1);
    ASSERT_TRUE(logs("no screenshot"));
    EXPECT_TRUE(kiosk().runs());
    ASSERT_EQ(mount("none", state.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, ""), 0);
    kiosk().signal(SIGUSR1);
    ASSERT_TRUE(logs("no screenshot"));
    ASSERT_EQ(mount("none", state.c_str(), "tmpfs", MS_REMOUNT, "size=4m"), 0);
    fs::remove(folder() / "state/full");
    copyModel(kBox, "b.glb"); // A change of models is when the list is written.
    ASSERT_TRUE(logs("shows " + (models() / "b.glb").string()));
    std::this_thread::sleep_for(500ms);
    EXPECT_NE(readText(folder() / "state/programs.manifest").find("# end"), std::string::npos);
    kiosk().signal(SIGTERM);
    EXPECT_EQ(kiosk().wait(), 0);
    umount(state.c_str());
}

TEST_F(KioskShow, KillsAtAnyTimeLeaveAListThatIsWhole) {
    copyModel(kBox, "a.glb");
    copyModel(kEngine, "b.glb");
    for (int kills = 0; kills < 8; ++kills) {
        start("[content]\nfolder = \"models\"\nseconds = 1\nfade-seconds = 0\n");
        std::this_thread::sleep_for(20ms + 170ms * kills);
        kiosk().signal(SIGKILL);
        kiosk().wait();
        const std::string manifest = readText(folder() / "state/programs.manifest");
        EXPECT_TRUE(manifest.empty() || manifest.find("# end") != std::string::npos) << manifest;
    }
    start("[content]\nfolder = \"models\"\nseconds = 1\n");
    ASSERT_TRUE(logs("shows"));
    EXPECT_EQ(log().find("manifest"), std::string::npos) << "a list was damaged";
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
