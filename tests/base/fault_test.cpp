// SPDX-License-Identifier: MIT
// Writers and readers whose disk is full, broken or cut off at each system call, and several writers of one
// manifest: nothing is lost, nothing is half there, and nothing of others is written over.
#include "franken/manifest.h"
#include "support/shell.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <thread>

#include <sys/stat.h>
#include <unistd.h>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

constexpr int kKilled = 0;
constexpr int kFaults[] = {ENOSPC, EIO, EMFILE, ENOMEM, EACCES, kKilled};
constexpr int kMostCalls = 60; // No more than that are made.

class FaultTest : public testing::Test {
protected:
    fs::path file() const { return m_folder / "disk" / "kiosk.txt"; }

    void put(const std::string& text) const {
        fs::remove_all(file().parent_path());
        fs::create_directories(file().parent_path());
        if (!text.empty())
            std::ofstream(file(), std::ios::binary) << text;
    }

    std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(file().parent_path()), {}));
    }

    // Exit code, or 128 + 9 where it was killed.
    Outcome act(const std::string& what, int call, int error, const char* others = "") const {
        return runIn(m_folder, "FRANKEN_FAULT='" + std::to_string(call) + " " + std::to_string(error) +
                                   others + "' " + FAULTY_CALLS + " " + what);
    }

    // Does `what` with each fault at each call, until there is no such call, each time after `prepare`;
    // `check` hears whether it succeeded. The calls after that one fail as well, or it alone does.
    template<typename Prepare, typename Check>
    void atEachCallAfter(Prepare prepare, const std::string& what, Check check) const {
        int faults = 0;
        for (const char* others : {"", " alone"})
            for (const int error : kFaults)
                for (int call = 1;; ++call, ++faults) {
                    SCOPED_TRACE("call " + std::to_string(call) + ", errno " + std::to_string(error) +
                                 others);
                    ASSERT_LT(call, kMostCalls);
                    prepare();
                    if (callsOf(what, call, error, others, check) < call)
                        break;
                }
        EXPECT_GE(faults, 24) << "the calls are not those of the program";
    }

    // Does `what` once. Returns how many calls it took.
    template<typename Check>
    int callsOf(const std::string& what, int call, int error, const char* others, Check check) const {
        const Outcome outcome = act(what, call, error, others);
        const bool killed = outcome.code == 128 + SIGKILL;
        EXPECT_TRUE(outcome.code == 0 || outcome.code == 1 || killed) << outcome.out << outcome.err;
        check(outcome.code == 0);
        if (!killed && error != EIO) { // Where nothing can be removed, nothing is.
            EXPECT_LE(filesThere(), 1u) << "a temporary file is left";
        }
        return killed ? call : std::atoi(outcome.out.c_str());
    }

    template<typename Check>
    void atEachCall(const std::string& before, const std::string& what, Check check) const {
        atEachCallAfter([&] { put(before); }, what, check);
    }

    const fs::path m_folder = emptyTestFolder();
};

std::string manifestOf(const std::string& names) { return toManifest(*parseManifest(names, "names")); }

std::size_t countIn(const fs::path& file) {
    const auto uses = readManifest(file);
    return uses ? uses->size() : 0;
}

const std::string kTwenty = [] {
    std::string names;
    for (const char* material : {"surface", "basecolor", "metalrough", "vertexcolor", "double"})
        for (const char* lights : {"sun1", "sun2", "sun4", "sun3"})
            names += std::string(material) + "+" + lights + "\n";
    return names;
}();

TEST_F(FaultTest, AppendingKeepsAllTwentyPrograms) {
    const std::string before = manifestOf(kTwenty);
    const std::size_t programs = parseManifest(before, "")->size();
    atEachCall(before, "append disk/kiosk.txt mask+sun1", [&](bool succeeded) {
        const std::size_t now = countIn(file());
        EXPECT_TRUE(now == programs + 1 || (!succeeded && now == programs)) << now;
    });
}

TEST_F(FaultTest, AFirstManifestIsWholeOrNotThere) {
    atEachCall("", "append disk/kiosk.txt mask+sun1", [&](bool succeeded) {
        if (succeeded || fs::exists(file())) {
            EXPECT_EQ(countIn(file()), 1u);
        }
    });
}

TEST_F(FaultTest, AListByHandKeepsItsComments) {
    const std::string before = "# the shop window\nsun1   # noon\n";
    atEachCall(before, "append disk/kiosk.txt mask+sun1", [&](bool succeeded) {
        const std::string now = readText(file());
        EXPECT_TRUE(now == before + "mask+sun1\n" || (!succeeded && now == before)) << now;
    });
}

TEST_F(FaultTest, AReaderNeverTakesAPart) {
    const std::string before = manifestOf(kTwenty);
    atEachCall(before, "read disk/kiosk.txt", [&](bool) { EXPECT_EQ(readText(file()), before); });
}

// A rename that reaches the disk before the text does leaves an empty file after a power cut, and one that
// does not reach it leaves the old one, although the writer was told that all is well.
TEST_F(FaultTest, TheTextIsOnTheDiskBeforeItTakesItsPlaceAndThenItsFolder) {
    for (const std::string what : {"write disk/kiosk.txt text", "append disk/kiosk.txt sun1"}) {
        put("");
        const Outcome outcome = act(what, 0, 0);
        ASSERT_EQ(outcome.code, 0) << outcome.out;
        const std::size_t names = outcome.out.find('\n') + 1;
        std::string last;
        std::istringstream calls(outcome.out.substr(names));
        for (std::string name; calls >> name;)
            if (name == "write" || name.starts_with("fsync") || name == "renameat")
                last += name + " ";
        EXPECT_EQ(last, "write fsync renameat fsync/ ") << what;
    }
}

// Who guesses the name of the temporary file is refused, whatever stands there.
TEST_F(FaultTest, ATemporaryFileOfOthersIsNotWrittenTo) {
    for (const bool link : {false, true}) {
        put("old");
        const fs::path victim = m_folder / "victim",
                       planted = file().parent_path() / ".kiosk.txt.0000000000000000.new";
        std::ofstream(victim) << "precious";
        link ? fs::create_symlink(victim, planted) : fs::copy(victim, planted);
        const Outcome outcome =
            runIn(m_folder, std::string("FRANKEN_NO_RANDOM=1 ") + FAULTY_CALLS + " write disk/kiosk.txt new");
        EXPECT_EQ(outcome.code, 1) << outcome.out;
        EXPECT_EQ(readText(victim), "precious");
        EXPECT_EQ(readText(planted), "precious");
        EXPECT_EQ(readText(file()), "old");
    }
}

TEST_F(FaultTest, AFileIsTheOldOneOrTheNewOne) {
    atEachCall("old", "write disk/kiosk.txt 'the new text'", [&](bool succeeded) {
        const std::string now = readText(file());
        EXPECT_TRUE(now == "the new text" || (!succeeded && now == "old")) << now;
    });
}

// What is there may be a link: where that cannot be told, it is not replaced.
TEST_F(FaultTest, ALinkStaysALink) {
    const fs::path target = m_folder / "target";
    const auto prepare = [&] {
        put("");
        std::ofstream(target) << "old";
        fs::create_symlink("../target", file());
    };
    atEachCallAfter(prepare, "write disk/kiosk.txt 'the new text'", [&](bool succeeded) {
        ASSERT_TRUE(fs::is_symlink(file()));
        const std::string now = readText(target);
        EXPECT_TRUE(now == "the new text" || (!succeeded && now == "old")) << now;
    });
}

// Somebody else's file keeps its owner, or is not written at all.
TEST_F(FaultTest, AnOwnerIsKept) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root may give files away: run as root";
    constexpr uid_t kNobody = 65534;
    const auto prepare = [&] {
        put("old");
        ASSERT_EQ(chown(file().c_str(), kNobody, kNobody), 0);
    };
    atEachCallAfter(prepare, "write disk/kiosk.txt 'the new text'", [&](bool) {
        struct stat status {};
        ASSERT_EQ(stat(file().c_str(), &status), 0);
        EXPECT_EQ(status.st_uid, kNobody);
    });
}

TEST_F(FaultTest, AFolderThatDoesNotReachTheDiskIsAnError) {
    put("old");
    const Outcome sound = act("sync disk", 0, 0);
    EXPECT_EQ(sound.code, 0) << sound.out;
    EXPECT_NE(sound.out.find("syncfs"), std::string::npos) << sound.out;
    for (const int error : {EIO, ENOSPC, ENOMEM, EMFILE})
        for (const int call : {1, 2})
            EXPECT_EQ(act("sync disk", call, error).code, 1) << call;
}

struct Foreign {
    const char* what;
    std::string text;
};

TEST_F(FaultTest, WhatIsNoManifestIsLeftAlone) {
    for (const auto& [what, text] : {
             Foreign{"a note", "Buy milk.\n"},
             {"a note with an end", "Buy milk.\n# end of the list\n"},
             {"a picture", std::string("\x89PNG\r\n\x1a\n\0\0", 10)},
             {"a list with a typo", "nromal+sun1\n"},
             {"a large file", std::string(kMaxManifestBytes + 1, 'x')},
         }) {
        put(text);
        const auto appended = appendToManifest(file(), *parseManifest("sun1", ""));
        ASSERT_FALSE(appended) << what;
        EXPECT_EQ(appended.error().code, "manifest.foreign") << what;
        EXPECT_FALSE(appended.error().remedy.empty());
        EXPECT_EQ(writeManifest(file(), *parseManifest("sun1", "")).error().code, "manifest.foreign") << what;
        EXPECT_EQ(readText(file()), text) << what;
    }
    std::filesystem::remove(file());
    ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
    EXPECT_EQ(appendToManifest(file(), *parseManifest("sun1", "")).error().code, "manifest.foreign")
        << "a pipe that nobody reads is not waited for";
}

TEST_F(FaultTest, WhatWasOursIsWrittenAnew) {
    const std::string whole = manifestOf(kTwenty);
    std::string changed = whole;
    changed[whole.size() / 2] ^= 1;
    for (const auto& [what, text] : {
             Foreign{"nothing", ""},
             {"an empty file", "\n"},
             {"zeros after a power cut", std::string(4096, '\0')},
             {"a cut", whole.substr(0, whole.size() / 2)},
             {"a cut in the first line", whole.substr(0, 9)},
             {"a changed bit", changed},
             {"another schema", "# FrankenShader manifest, schema 99\nfuture+words\n"},
         }) {
        put(text);
        const auto appended = appendToManifest(file(), *parseManifest("sun1", ""));
        EXPECT_TRUE(appended) << what << ": " << (appended ? "" : toString(appended.error()));
        EXPECT_EQ(countIn(file()), 1u) << what;
    }
}

// Two and eight processes add programs of their own, while a reader looks: it never sees a part.
TEST_F(FaultTest, SeveralWritersLoseNothing) {
    const auto uses = *parseManifest(kTwenty, "");
    for (const std::size_t writers : {2u, 8u}) {
        put(manifestOf("unlit"));
        std::string command;
        for (std::size_t i = 0; i < writers; ++i) {
            command += "( ";
            for (std::size_t j = i; j < uses.size(); j += writers)
                command += std::string(FAULTY_CALLS) + " append disk/kiosk.txt " +
                           toName(uses[j].permutation) + " || exit 1; ";
            command += ") & pids=\"$pids $!\"; ";
        }
        command += "for pid in $pids; do wait $pid || echo failed; done";
        std::atomic<bool> done = false;
        std::size_t wrong = 0, looks = 0;
        std::thread writer([&] {
            EXPECT_EQ(runIn(m_folder, command).out.find("failed"), std::string::npos);
            done = true;
        });
        for (std::size_t last = 1; !done; ++looks) {
            const std::size_t now = countIn(file());
            wrong += now < last;
            last = now;
        }
        writer.join();
        EXPECT_EQ(wrong, 0u) << "of " << looks;
        EXPECT_EQ(countIn(file()), uses.size() + 1) << writers;
        EXPECT_EQ(filesThere(), 1u);
    }
}

} // namespace
} // namespace franken::test
