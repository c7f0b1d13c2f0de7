// SPDX-License-Identifier: MIT
// A kiosk whose disk answers with EIO, at each call of each file that it writes or reads. In virtual time.
#include "franken/file.h"
#include "franken/image.h"
#include "kiosk/vm_kiosk.h"
#include "support/shell.h"

#include <csignal>
#include <cstdlib>
#include <thread>

namespace franken::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string kConfig =
    "heartbeat = \"beat\"\n[content]\nfolder = \"models\"\nseconds = 8\nfade-seconds = 0\n"
    "[show]\nturn-seconds = 0\nanimations = false\n"; // Draws at changes alone.

class KioskDisk : public KioskInGuest {
protected:
    void SetUp() override {
        KioskInGuest::SetUp();
        if (IsSkipped())
            return;
        setenv("FRANKEN_DISK", folder().c_str(), 1);
        setenv("FRANKEN_FAULTS", (folder() / "faults").c_str(), 1);
        copyModel(kBox, "a.glb");
        copyModel(kBox, "b.glb");
    }
    void TearDown() override {
        unsetenv("FRANKEN_FAULTS");
        KioskInGuest::TearDown();
    }
    /// The names of calls that fail from now on.
    void breakDisk(const std::string& calls) const {
        std::ofstream(folder() / "faults.new") << calls;
        fs::rename(folder() / "faults.new", folder() / "faults");
    }
    /// Each file is not there, or whole.
    void expectWholeFiles() const {
        const std::string manifest = readText(folder() / "state/programs.manifest");
        EXPECT_TRUE(manifest.empty() || manifest.find("# end") != std::string::npos) << manifest;
        const std::string statistics = readText(folder() / "kiosk.prom");
        EXPECT_TRUE(statistics.empty() ||
                    statistics.find("\nfrankenshader_kiosk_start_time_seconds ") != std::string::npos)
            << statistics;
        const std::string beat = readText(folder() / "beat");
        EXPECT_TRUE(beat.empty() || beat.ends_with('\n')) << beat;
        if (const auto file = franken::readFile(folder() / "state/screenshot.png", 1 << 20)) {
            EXPECT_TRUE(decodeImage(*file));
        }
    }
    bool allFilesAreThere() const {
        return fs::exists(folder() / "state/programs.manifest") && fs::exists(folder() / "kiosk.prom") &&
               fs::exists(folder() / "beat") && fs::exists(folder() / "state/screenshot.png");
    }
    /// Lets the kiosk write all of its files while these calls fail.
    void expectToSurvive(const std::string& calls) {
        SCOPED_TRACE(calls);
        breakDisk(calls);
        kiosk().signal(SIGUSR1);
        EXPECT_TRUE(logs("no screenshot"));
        EXPECT_TRUE(logs("Input/output error", 0));
        std::this_thread::sleep_for(16s); // Statistics are the rarest: each 15 s.
        expectWholeFiles();
        EXPECT_TRUE(kiosk().runs());
        EXPECT_TRUE(logs("shows", 20)) << "it goes on";
    }
    void expectToRecover() {
        const std::size_t before = log().size();
        breakDisk("");
        kiosk().signal(SIGUSR1);
        std::this_thread::sleep_for(16s);
        const std::string news = log().substr(before);
        for (const char* text : {"screenshot: ", "statistics are written again",
                                 "the list of programs is kept again", "the heartbeat is written again"})
            EXPECT_NE(news.find(text), std::string::npos) << text << "\n" << news;
        expectWholeFiles();
        EXPECT_TRUE(allFilesAreThere());
    }
};

TEST_F(KioskDisk, EioAtEachCallOfAWriteCostsTheFileAndNothingElse) {
    breakDisk("create");
    start(kConfig, FAULTY_KIOSK);
    ASSERT_TRUE(logs("shows"));
    EXPECT_TRUE(logs("the list of programs is not kept"));
    for (const char* calls : {"create", "folder", "write", "fsync", "close", "rename", "write unlink"})
        expectToSurvive(calls);
    expectToRecover();
    breakDisk("write");
    copyModel(kBox, "c.glb");
    fs::copy(kModels + "glTF-Sample-Models/AnimatedMorphCube-glTF",
             models() / "cube"); // Needs programs of its own.
    EXPECT_TRUE(logs("the list of programs is not kept", 20));
    for (const char* calls : {"create", "folder", "fchmod", "write", "fsync", "close", "rename"})
        expectToSurvive(calls);
    expectToRecover();
    kiosk().signal(SIGTERM);
    EXPECT_EQ(kiosk().wait(), 0);
}

TEST_F(KioskDisk, EioAtAReadLeavesTheConfigurationAndThePictureAsTheyWere) {
    start(kConfig, FAULTY_KIOSK);
    ASSERT_TRUE(logs("shows"));
    breakDisk("read");
    writeConfig(kConfig);
    ASSERT_TRUE(logs("the configuration stays as it was"));
    ASSERT_TRUE(logs("is skipped", 30));
    std::this_thread::sleep_for(5s);
    EXPECT_FALSE(logs("is skipped", 0)) << "it is told once";
    EXPECT_GT(brightShare(picture("kiosk_unreadable")), 0.1) << "the last model stays";
    breakDisk("");
    copyModel(kBox, "a.glb");
    EXPECT_TRUE(logs("shows", 30));
    writeConfig(kConfig);
    EXPECT_TRUE(logs("the configuration was read again"));
    kiosk().signal(SIGTERM);
    EXPECT_EQ(kiosk().wait(), 0);
}

} // namespace
} // namespace franken::test
