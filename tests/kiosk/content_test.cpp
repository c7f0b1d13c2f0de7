// SPDX-License-Identifier: MIT
#include "kiosk/content/background_reader.h"
#include "kiosk/content/loader.h"
#include "kiosk/content/playlist.h"
#include "kiosk/content/watched_folder.h"
#include "support/shell.h"

#include <gtest/gtest.h>

#include <poll.h>

#include <algorithm>

namespace franken::test {
namespace {

namespace fs = std::filesystem;
using kiosk::Playlist;
using Paths = std::vector<fs::path>;

TEST(KioskPlaylist, GoesRoundBothWays) {
    Playlist list;
    EXPECT_FALSE(list.after({}));
    list.set({"a", "b", "c"});
    EXPECT_EQ(list.after({}), "a");
    EXPECT_EQ(list.after({}, -1), "c");
    EXPECT_EQ(list.after("c"), "a");
    EXPECT_EQ(list.after("a", -1), "c");
}

TEST(KioskPlaylist, SkipsBrokenOnesUntilTheyChange) {
    Playlist list;
    list.set({"/m/a", "/m/b", "/n/c"});
    list.markBroken("/m/b", "cut off");
    EXPECT_EQ(list.after("/m/a"), "/n/c");
    list.changed("/n/c");
    EXPECT_EQ(list.after("/m/a"), "/n/c");
    list.changed("/m/texture.png");
    EXPECT_EQ(list.after("/m/a"), "/m/b");
    list.markBroken("/m/b", "its buffer is missing");
    list.changed("/m/buffers/b.bin");
    EXPECT_EQ(list.after("/m/a"), "/m/b") << "a deeper folder";
    list.markBroken("/m/b", "cut off");
    list.changed("/m");
    EXPECT_EQ(list.after("/m/a"), "/m/b") << "anything in the folder";
    for (const char* each : {"/m/a", "/m/b", "/n/c"})
        list.markBroken(each, "gone");
    EXPECT_FALSE(list.after("/m/a")) << "nothing whole is left";
}

TEST(KioskPlaylist, AModelThatWentIsFollowedByItsFollower) {
    Playlist list;
    list.set({"a", "c"});
    EXPECT_EQ(list.after("b"), "c");
    EXPECT_EQ(list.after("b", -1), "a");
    EXPECT_EQ(list.after("d"), "a");
}

class KioskFolder : public testing::Test {
protected:
    fs::path m_folder = emptyTestFolder();
    void write(const fs::path& name) const { std::ofstream(m_folder / name) << "x"; }
};

TEST_F(KioskFolder, AFileIsThereOnceItIsClosed) {
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    std::ofstream half(m_folder / "a.glb");
    half << "x" << std::flush;
    folder.dispatch();
    EXPECT_TRUE(folder.models().empty()) << "it is still being written";
    half.close();
    EXPECT_EQ(folder.dispatch(), Paths{m_folder / "a.glb"});
    EXPECT_EQ(folder.models(), Paths{m_folder / "a.glb"});
}

TEST_F(KioskFolder, AFileIsThereOnceItIsRenamedAndGoneOnceItIsRemoved) {
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    write(".b.glb.Xq3"); // As rsync does.
    folder.dispatch();
    EXPECT_TRUE(folder.models().empty());
    fs::rename(m_folder / ".b.glb.Xq3", m_folder / "b.GLB");
    folder.dispatch();
    EXPECT_EQ(folder.models(), Paths{m_folder / "b.GLB"});
    fs::remove(m_folder / "b.GLB");
    EXPECT_EQ(folder.dispatch(), Paths{m_folder / "b.GLB"});
    EXPECT_TRUE(folder.models().empty());
}

TEST_F(KioskFolder, ALinkIsThereAtOnce) {
    write(".hidden");
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    fs::create_symlink(m_folder / ".hidden", m_folder / "a.glb");
    fs::create_hard_link(m_folder / ".hidden", m_folder / "b.glb");
    EXPECT_EQ(folder.dispatch(), (Paths{m_folder / "a.glb", m_folder / "b.glb"}));
    EXPECT_EQ(folder.models(), (Paths{m_folder / "a.glb", m_folder / "b.glb"}));
}

TEST_F(KioskFolder, FoldersInItAreSeenToo) {
    write("z.gltf");
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    fs::create_directory(m_folder / "bottle");
    folder.dispatch();
    write("bottle/bottle.gltf");
    write("bottle/bottle.png");
    EXPECT_EQ(folder.dispatch(), (Paths{m_folder / "bottle/bottle.gltf", m_folder / "bottle/bottle.png"}));
    EXPECT_EQ(folder.models(), (Paths{m_folder / "bottle/bottle.gltf", m_folder / "z.gltf"}));
}

TEST_F(KioskFolder, ALinkToTheFolderItselfAddsNothingAndTwoLinksToOneFolderAreTwoFolders) {
    fs::create_directory(m_folder / ".shared");
    fs::create_directory_symlink(".", m_folder / "itself");
    fs::create_directory_symlink(".shared", m_folder / "one");
    fs::create_directory_symlink(".shared", m_folder / "two");
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    EXPECT_FALSE(folder.needsRescans()) << "the folder is watched by its own name";
    std::ofstream half(m_folder / ".shared/a.glb");
    folder.dispatch();
    EXPECT_TRUE(folder.models().empty()) << "it is being written, by any name";
    half.close();
    write("b.glb");
    Paths changed = folder.dispatch();
    std::sort(changed.begin(), changed.end()); // Folders come as the file system has them.
    EXPECT_EQ(changed, (Paths{m_folder / "b.glb", m_folder / "one/a.glb", m_folder / "two/a.glb"}));
    EXPECT_EQ(folder.models(), (Paths{m_folder / "b.glb", m_folder / "one/a.glb", m_folder / "two/a.glb"}));
}

TEST_F(KioskFolder, ALinkIsFollowedToAnotherFolder) {
    fs::create_directory(m_folder / ".1");
    fs::create_directory(m_folder / ".2");
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    fs::create_directory_symlink(".1", m_folder / "current");
    folder.dispatch();
    write(".1/a.glb");
    EXPECT_EQ(folder.dispatch(), Paths{m_folder / "current/a.glb"});
    fs::create_directory_symlink(".2", m_folder / ".next");
    fs::rename(m_folder / ".next", m_folder / "current");
    folder.dispatch();
    write(".2/b.glb");
    EXPECT_EQ(folder.dispatch(), Paths{m_folder / "current/b.glb"});
    write(".1/c.glb");
    EXPECT_EQ(folder.dispatch(), Paths()) << "nothing leads there any more";
}

TEST_F(KioskFolder, AFolderThatIsMovedForthAndBackHidesNothing) {
    fs::create_directory(m_folder / "bottle");
    kiosk::WatchedFolder folder(m_folder, [](LogLevel, std::string_view) {});
    std::ofstream half(m_folder / "bottle/a.glb");
    folder.dispatch();
    EXPECT_TRUE(folder.models().empty());
    fs::rename(m_folder / "bottle", m_folder / "other");
    folder.dispatch();
    half.close();
    fs::rename(m_folder / "other", m_folder / "bottle");
    folder.dispatch();
    EXPECT_EQ(folder.models(), (Paths{m_folder / "bottle/a.glb"}));
}

TEST_F(KioskFolder, AFolderMayComeAndGo) {
    const fs::path late = m_folder / "late";
    kiosk::WatchedFolder folder(late, [](LogLevel, std::string_view) {});
    EXPECT_FALSE(folder.present());
    fs::create_directory(late);
    write("late/a.glb");
    folder.rescan();
    EXPECT_TRUE(folder.present());
    EXPECT_EQ(folder.models().size(), 1U);
    fs::remove_all(late);
    folder.dispatch();
    EXPECT_FALSE(folder.present());
    EXPECT_TRUE(folder.models().empty());
}

TEST_F(KioskFolder, TheLastRequestOfAReaderIsAnswered) {
    std::mutex gate;
    gate.lock();
    kiosk::BackgroundReader<std::string> reader([&gate](const fs::path& path, const std::stop_token&) {
        const std::lock_guard wait(gate);
        return path.string();
    });
    reader.request("first");
    reader.request("second"); // Returns although the first is being read.
    gate.unlock();
    pollfd ready{reader.descriptor(), POLLIN, 0};
    ASSERT_EQ(poll(&ready, 1, 10'000), 1);
    EXPECT_EQ(reader.take(), "second");
    EXPECT_FALSE(reader.take());
}

TEST_F(KioskFolder, CaptionsComeFromATextBesideOrFromTheName) {
    EXPECT_EQ(kiosk::captionOf(m_folder / "red_fox-2.glb"), "red fox 2");
    std::ofstream(m_folder / "red_fox-2.txt") << "\xEF\xBB\xBF"
                                              << "Vulpes vulpes\r\nsecond line\n";
    EXPECT_EQ(kiosk::captionOf(m_folder / "red_fox-2.glb"), "Vulpes vulpes");
}

} // namespace
} // namespace franken::test
