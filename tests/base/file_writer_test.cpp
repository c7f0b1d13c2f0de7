// SPDX-License-Identifier: MIT
// How files are written: all or nothing, through links and into devices, and never over what is not ours.
// Device nodes are made here: the machine's own are left alone.
#include "franken/file.h"
#include "franken/file_writer.h"
#include "support/shell.h"

#include <atomic>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace franken {
namespace {

namespace fs = std::filesystem;
using test::readText;

class FileWriterTest : public testing::Test {
protected:
    fs::path path(const std::string& name) const { return m_folder / name; }
    void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
    unsigned mode(const std::string& name) const {
        struct stat status {};
        return stat(path(name).c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
    }
    std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
    }

    const fs::path m_folder = test::emptyTestFolder();
};

TEST_F(FileWriterTest, WritesANewFileByTheUmask) {
    const mode_t before = umask(027);
    ASSERT_TRUE(writeFile(path("new"), "text"));
    umask(before);
    EXPECT_EQ(readText(path("new")), "text");
    EXPECT_EQ(mode("new"), 0640u);
    EXPECT_EQ(filesThere(), 1u);
}

TEST_F(FileWriterTest, KeepsModeAndOwner) {
    put("old", "old");
    fs::permissions(path("old"), fs::perms(0604));
    const bool root = geteuid() == 0;
    if (root) {
        ASSERT_EQ(chown(path("old").c_str(), 1, 2), 0);
    }
    ASSERT_TRUE(writeFile(path("old"), "new"));
    EXPECT_EQ(readText(path("old")), "new");
    EXPECT_EQ(mode("old"), 0604u);
    struct stat status {};
    ASSERT_EQ(stat(path("old").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, root ? 1 : geteuid());
}

TEST_F(FileWriterTest, RefusesAFileThatNobodyMayWriteTo) {
    put("old", "old");
    fs::permissions(path("old"), fs::perms(0444));
    const Result<void> written = writeFile(path("old"), "new");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, "file.write");
    EXPECT_NE(written.error().what.find("ermission"), std::string::npos);
    EXPECT_EQ(readText(path("old")), "old");
    EXPECT_EQ(filesThere(), 1u);
}

TEST_F(FileWriterTest, FollowsALinkAndLeavesIt) {
    fs::create_directory(path("disk"));
    put("disk/target", "old");
    fs::create_symlink("disk/target", path("link"));
    fs::create_symlink("link", path("second"));
    fs::create_symlink("disk/new", path("dangling"));
    ASSERT_TRUE(writeFile(path("second"), "new"));
    ASSERT_TRUE(writeFile(path("dangling"), "made"));
    EXPECT_TRUE(fs::is_symlink(path("link")) && fs::is_symlink(path("second")) &&
                fs::is_symlink(path("dangling")));
    EXPECT_EQ(readText(path("disk/target")), "new");
    EXPECT_EQ(readText(path("disk/new")), "made");
    fs::create_symlink("loop", path("loop"));
    EXPECT_FALSE(writeFile(path("loop"), "text"));
}

// Who knows the name of the temporary file can plant a link of that name.
TEST_F(FileWriterTest, PlantedLinksAreNotFollowed) {
    put("victim", "precious");
    for (const char* guess : {"out.new", "out.part", "out.tmp", ".out.new", "out~"})
        fs::create_symlink("victim", path(guess));
    ASSERT_TRUE(writeFile(path("out"), "text"));
    EXPECT_EQ(readText(path("victim")), "precious");
}

TEST_F(FileWriterTest, WritesIntoPipesAndDevices) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = readText(path("pipe")); });
    EXPECT_TRUE(writeFile(path("pipe"), "through"));
    reader.join();
    EXPECT_EQ(received, "through");
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
    if (mknod(path("null").c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0 ||
        mknod(path("full").c_str(), S_IFCHR | 0666, makedev(1, 7)) != 0 || !std::ofstream(path("null")))
        GTEST_SKIP() << "no device node can be made or opened here: run as root, on a disk without nodev";
    fs::create_symlink("null", path("link"));
    EXPECT_TRUE(writeFile(path("null"), "gone"));
    EXPECT_TRUE(writeFile(path("link"), "gone"));
    EXPECT_TRUE(fs::is_character_file(path("null")) && fs::is_symlink(path("link")));
    const Result<void> full = writeFile(path("full"), "text");
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().remedy.find("room"), std::string::npos) << full.error().remedy;
    EXPECT_TRUE(fs::is_character_file(path("full")));
}

TEST_F(FileWriterTest, StandardOutputIsWrittenToAsItIs) {
    // A file that the shell opened has no place of its own to be replaced at.
    const int saved = dup(STDOUT_FILENO);
    const int file = open(path("captured").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    dup2(file, STDOUT_FILENO);
    const Result<void> written = writeFile("/proc/self/fd/1", "text");
    dup2(saved, STDOUT_FILENO);
    close(saved);
    struct stat before {};
    struct stat after {};
    fstat(file, &before);
    stat(path("captured").c_str(), &after);
    close(file);
    EXPECT_TRUE(written);
    EXPECT_EQ(before.st_ino, after.st_ino);
    EXPECT_EQ(readText(path("captured")), "text");
}

TEST_F(FileWriterTest, SaysWhatCannotBeWritten) {
    fs::create_directory(path("folder"));
    put("file", "");
    for (const char* name : {"folder", "file/below", "nowhere/file", "folder/"}) {
        const Result<void> written = writeFile(path(name), "text");
        ASSERT_FALSE(written) << name;
        EXPECT_EQ(written.error().where, path(name).string());
        EXPECT_FALSE(written.error().remedy.empty());
    }
    EXPECT_EQ(filesThere(), 2u);
    EXPECT_TRUE(fs::is_empty(path("folder")));
    EXPECT_TRUE(writeFile(path(std::string(250, 'n')), "a long name"));
}

TEST_F(FileWriterTest, AnUnfinishedFileIsNotThere) {
    put("old", "old");
    {
        Result<FileWriter> file = FileWriter::open(path("old"));
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->write("half of"));
        EXPECT_EQ(filesThere(), 2u);
    }
    EXPECT_EQ(readText(path("old")), "old");
    EXPECT_EQ(filesThere(), 1u);
}

TEST_F(FileWriterTest, AnOutputIsNoInput) {
    put("sky.hdr", "");
    fs::create_directory(path("faces"));
    put("faces/px.hdr", "");
    fs::create_directories(path("glsl/fragment/math"));
    put("glsl/fragment/math/pi.glsl", "");
    fs::create_directory_symlink("glsl", path("snippets"));
    fs::create_symlink("sky.hdr", path("link"));
    const auto refused = [&](const char* output, const char* input) {
        return !checkNotInput(path(output), {{path(input)}});
    };
    EXPECT_TRUE(refused("sky.hdr", "sky.hdr"));
    EXPECT_TRUE(refused("link", "sky.hdr"));
    EXPECT_TRUE(refused("faces/../sky.hdr", "link"));
    EXPECT_TRUE(refused("faces/px.hdr", "faces"));
    EXPECT_TRUE(refused("glsl/fragment/math/pi.glsl", "glsl"));
    EXPECT_TRUE(refused("glsl/fragment/math/pi.glsl", "snippets"));
    EXPECT_FALSE(refused("glsl/fragment/math/pi.glsl", "faces"));
    EXPECT_FALSE(refused("glsl/fragment/math/new.glsl", "glsl"));
    EXPECT_FALSE(refused("faces/new.sky", "faces"));
    EXPECT_FALSE(refused("sky.sky", "sky.hdr"));
    EXPECT_FALSE(refused("sky.hdr", "nowhere"));
}

TEST_F(FileWriterTest, ALockKeepsOthersOut) {
    put("counter", "0");
    std::atomic<int> failed = 0;
    const auto countUp = [&] {
        for (int i = 0; i < 25; ++i) {
            const Result<FileLock> lock = FileLock::take(path("counter"));
            const int value = std::stoi(readText(path("counter")));
            failed +=
                !lock || !writeFile(path("counter"), std::to_string(value + 1), FileWriter::Sync::Later);
        }
    };
    std::thread first(countUp), second(countUp);
    first.join();
    second.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(readText(path("counter")), "50");
    EXPECT_EQ(FileLock::take("/nowhere/file").error().code, "file.lock");
}

TEST_F(FileWriterTest, ReadsAFileThatIsThere) {
    put("file", "text");
    const auto there = readFileIfThere(path("file"), 4);
    ASSERT_TRUE(there && *there);
    EXPECT_EQ((*there)->size(), 4u);
    const auto missing = readFileIfThere(path("none"), 4);
    EXPECT_TRUE(missing && !*missing);
    EXPECT_EQ(readFile(path("none"), 4).error().code, "file.open");
    EXPECT_EQ(readFileIfThere(path("file"), 3).error().code, "file.size");
    EXPECT_EQ(readFileIfThere(m_folder, 4).error().code, "file.open");
    EXPECT_EQ(readFileIfThere(path("file/below"), 4).error().code, "file.open");
}

// A pipe has no size, and a device no end: neither is a file of no bytes.
TEST_F(FileWriterTest, ReadsNothingButFiles) {
    const auto codeOf = [&](const char* name) {
        const auto bytes = readFile(path(name), 4);
        return bytes ? "read" : bytes.error().code;
    };
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(codeOf("pipe"), "file.open");
    if (mknod(path("zero").c_str(), S_IFCHR | 0600, makedev(1, 5)) != 0)
        GTEST_SKIP() << "a device node can be made by root alone";
    EXPECT_EQ(codeOf("zero"), "file.open");
}

} // namespace
} // namespace franken
