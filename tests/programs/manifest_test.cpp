// SPDX-License-Identifier: MIT
// The manifest of a run: what is written is read back, and anything else is a clean miss.
#include "franken/manifest.h"

#include "franken/generator/effect.h"
#include "support/shell.h"

#include <csignal>
#include <set>

#include <sys/resource.h>
#include <unistd.h>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

ProgramUse use(std::string_view name) {
    const Permutation permutation = canonicalise(*parseName(name))->permutation;
    return {permutation, {.blend = permutation.alpha == Alpha::Blend}};
}

std::vector<ProgramUse> someUses() {
    std::vector<ProgramUse> uses = {use("basecolor.normal+sun1"), use("blend+sun1"), use("surface"),
                                    use("sky+aces"), use("view-normal")};
    uses[0].state.wraps[0] = {Wrap::ClampToEdge, Wrap::MirroredRepeat};
    uses[0].state.wraps[7] = {Wrap::Repeat, Wrap::Repeat};
    uses[4].state.blend = true;
    return uses;
}

/// A folder of its own, and what was logged.
class ManifestTest : public testing::Test {
protected:
    fs::path file() const { return m_folder / "warm.manifest"; }
    void put(std::string_view text) const { std::ofstream(file(), std::ios::binary) << text; }
    std::size_t filesThere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
    }

    std::vector<ProgramUse> readOrNothing() {
        m_log.clear();
        return readManifestOrNothing(file(),
                                     [&](LogLevel, std::string_view text) { m_log.emplace_back(text); });
    }

    std::vector<std::string> m_log;

private:
    const fs::path m_folder = emptyTestFolder();
};

constexpr char kDarker[] = "//! light\nvec3 onLight(vec3 color) {\n  return 0.5 * color;\n}\n";

SnippetSet setWith(const char* name, const std::string& text) {
    return *SnippetSet::builtIn().with(*Effect::parse(name, text, "effect.glsl"));
}

ProgramUse useOf(const char* name, const SnippetSet& set) {
    return {canonicalise(*parseName(name, set))->permutation, {}};
}

TEST(ManifestOfEffects, NamesThemAndSkipsWhatTheRunHasNotGot) {
    const SnippetSet set = setWith("dark", kDarker);
    const std::vector<ProgramUse> uses = {useOf("sun1", set), useOf("sun1+dark", set)};
    const std::string text = toManifest(uses, set);
    EXPECT_NE(text.find("sun1+" + set.effects()[0].word() + "\n"), std::string::npos) << text;
    std::string told;
    const Log log = [&](LogLevel, std::string_view line) { told.append(line).append("\n"); };
    const auto same = parseManifest(text, "warm", set, log);
    ASSERT_TRUE(same);
    EXPECT_EQ(*same, uses);
    EXPECT_EQ(told, "");
    for (const auto& [other, code] :
         {std::pair(SnippetSet::builtIn(), "[effect.missing]"),
          {setWith("dark", std::string(kDarker) + "// 2\n"), "[effect.changed]"}}) {
        told.clear();
        const auto rest = parseManifest(text, "warm", other, log);
        ASSERT_TRUE(rest);
        EXPECT_EQ(*rest, std::vector<ProgramUse>{uses[0]});
        EXPECT_NE(told.find("warm:3"), std::string::npos) << told;
        EXPECT_NE(told.find(code), std::string::npos) << told;
    }
}

// Two kiosks with effects of their own share a file: neither loses the other's lines. Those of a text that is
// gone go.
TEST_F(ManifestTest, LinesOfAnotherRunsEffectStay) {
    const SnippetSet dark = setWith("dark", kDarker), dim = setWith("dim", kDarker);
    const SnippetSet edited = setWith("dark", std::string(kDarker) + "// 2\n");
    ASSERT_TRUE(writeManifest(file(), std::vector{useOf("sun1+dark", dark)}, dark));
    ASSERT_TRUE(appendToManifest(file(), std::vector{useOf("sun2+dim", dim)}, dim));
    ASSERT_TRUE(readManifest(file(), dark));
    EXPECT_EQ(*readManifest(file(), dark), std::vector{useOf("sun1+dark", dark)});
    EXPECT_EQ(*readManifest(file(), dim), std::vector{useOf("sun2+dim", dim)});
    ASSERT_TRUE(appendToManifest(file(), std::vector{useOf("sun1+dark", edited)}, edited));
    EXPECT_TRUE(readManifest(file(), dark)->empty());
    EXPECT_EQ(*readManifest(file(), edited), std::vector{useOf("sun1+dark", edited)});
    EXPECT_EQ(*readManifest(file(), dim), std::vector{useOf("sun2+dim", dim)});
}

TEST_F(ManifestTest, AProgramThatHasNoNameHereSpoilsNoList) {
    const SnippetSet dark = setWith("dark", kDarker);
    const std::vector<ProgramUse> uses = {use("sun1"), useOf("sun1+dark", dark)};
    const std::vector<ProgramUse> named = {use("sun1")};
    ASSERT_TRUE(writeManifest(file(), uses));
    EXPECT_EQ(*readManifest(file()), named);
    ASSERT_TRUE(appendToManifest(file(), uses));
    EXPECT_EQ(*readManifest(file()), named);
    put("sun1\n");
    ASSERT_TRUE(appendToManifest(file(), uses));
    EXPECT_EQ(*readManifest(file()), named);
}

TEST_F(ManifestTest, WhatIsWrittenIsReadBack) {
    ASSERT_TRUE(writeManifest(file(), someUses()));
    const Result<std::vector<ProgramUse>> read = readManifest(file());
    ASSERT_TRUE(read) << toString(read.error());
    EXPECT_EQ(*read, someUses());
    EXPECT_EQ(filesThere(), 1u) << "nothing is left beside it";
}

TEST_F(ManifestTest, IsTextThatAPersonReads) {
    EXPECT_EQ(toManifest(someUses()), "# FrankenShader manifest, schema 2\n"
                                      "basecolor.normal+sun1 wrap0=cm wrap7=rr\n"
                                      "blend+sun1\n"
                                      "surface\n"
                                      "sky+aces\n"
                                      "view-normal blend=on\n"
                                      "# end 5 8c2f90b0\n");
}

TEST_F(ManifestTest, WrapsHaveTheirLetters) {
    const auto wrapsOf = [](const char* line) { return parseManifest(line, "line")->at(0).state.wraps[0]; };
    EXPECT_EQ(wrapsOf("basecolor+sun1 wrap0=rc"), (DrawState::Wraps{Wrap::Repeat, Wrap::ClampToEdge}));
    EXPECT_EQ(wrapsOf("basecolor+sun1 wrap0=mr"), (DrawState::Wraps{Wrap::MirroredRepeat, Wrap::Repeat}));
}

TEST_F(ManifestTest, AnEmptyOneIsWhole) {
    const Result<std::vector<ProgramUse>> read = parseManifest(toManifest({}), "text");
    ASSERT_TRUE(read) << toString(read.error());
    EXPECT_TRUE(read->empty());
}

TEST_F(ManifestTest, CutAtAnyByteItIsAMissWithOneLine) {
    const std::string whole = toManifest(someUses());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        put(whole.substr(0, size));
        EXPECT_TRUE(readOrNothing().empty()) << "cut at " << size;
        EXPECT_EQ(m_log.size(), 1u) << "cut at " << size;
    }
    put(whole);
    EXPECT_EQ(readOrNothing(), someUses());
    EXPECT_TRUE(m_log.empty());
}

TEST_F(ManifestTest, WithAnyByteChangedItIsAMissWithOneLine) {
    const std::string whole = toManifest(someUses());
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        put(changed);
        EXPECT_TRUE(readOrNothing().empty()) << "changed at " << at;
        EXPECT_EQ(m_log.size(), 1u) << "changed at " << at;
    }
}

struct Refused {
    const char* text;
    const char* code;
};

TEST_F(ManifestTest, SaysWhatIsWrong) {
    for (const auto& [text, code] :
         {Refused{"# FrankenShader manifest, schema 9\nsurface\n", "manifest.schema"},
          {"# FrankenShader manifest, schema 2\nsurface\n", "manifest.damaged"},
          {"", "manifest.empty"},
          {"# nothing\n\n", "manifest.empty"},
          {"nromal\n", "manifest.line"},
          {"basecolor normal\n", "manifest.line"},
          {"spots\n", "manifest.line"},
          {"surface wrap16=rr\n", "manifest.line"},
          {"surface wrap=rr\n", "manifest.line"},
          {"surface wrap1rr\n", "manifest.line"},
          {"surface wrap0=rx\n", "manifest.line"},
          {"surface wrap0=r\n", "manifest.line"},
          {"surface blend=yes\n", "manifest.line"}}) {
        const Result<std::vector<ProgramUse>> read = parseManifest(text, "warm.txt");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, code) << text;
        EXPECT_EQ(read.error().where.substr(0, 8), "warm.txt");
    }
    EXPECT_EQ(parseManifest(std::string(kMaxManifestBytes + 1, '\n'), "").error().code, "manifest.size");
}

TEST_F(ManifestTest, KeepsTheWrapsOfEveryUnit) {
    std::vector<ProgramUse> uses(kTextureUnits, use("basecolor"));
    for (std::size_t unit = 0; unit < uses.size(); ++unit)
        uses[unit].state.wraps[unit] = {Wrap::MirroredRepeat, Wrap::ClampToEdge};
    const Result<std::vector<ProgramUse>> read = parseManifest(toManifest(uses), "text");
    ASSERT_TRUE(read) << toString(read.error());
    EXPECT_EQ(*read, uses);
    std::set<std::uint64_t> bits;
    for (const ProgramUse& each : uses)
        bits.insert(toBits(each.state, 0xFFFF));
    EXPECT_EQ(bits.size(), kTextureUnits) << "each state has a number of its own";
}

TEST_F(ManifestTest, ReadsAListByHand) {
    const Result<std::vector<ProgramUse>> read =
        parseManifest("# mine\n\n  basecolor+sun1 \t wrap0=cc  # a comment\r\nblend", "text");
    ASSERT_TRUE(read) << toString(read.error());
    std::vector<ProgramUse> expected = {use("basecolor+sun1"), use("blend")};
    expected[0].state.wraps[0] = DrawState::kClamped;
    EXPECT_EQ(*read, expected);
}

TEST_F(ManifestTest, AppendsWhatIsNewAndReplacesWhatIsBroken) {
    const std::vector<ProgramUse> uses = someUses();
    ASSERT_TRUE(appendToManifest(file(), {{uses[0]}}));
    ASSERT_TRUE(appendToManifest(file(), {{uses[1], uses[0]}}));
    EXPECT_EQ(*readManifest(file()), (std::vector<ProgramUse>{uses[0], uses[1]}));
    const fs::file_time_type before = fs::last_write_time(file());
    ASSERT_TRUE(appendToManifest(file(), {{uses[1]}}));
    EXPECT_EQ(fs::last_write_time(file()), before) << "nothing new, nothing written";
    put("# FrankenShader manifest, schema 9\n");
    ASSERT_TRUE(appendToManifest(file(), {{uses[2]}}));
    EXPECT_EQ(*readManifest(file()), std::vector<ProgramUse>{uses[2]});
}

TEST_F(ManifestTest, AMissingFileAndAFolderAreMisses) {
    EXPECT_TRUE(readOrNothing().empty());
    EXPECT_EQ(m_log.size(), 1u);
    fs::create_directory(file());
    EXPECT_TRUE(readOrNothing().empty());
    EXPECT_EQ(m_log.size(), 1u);
    EXPECT_EQ(writeManifest(file(), someUses()).error().code, "manifest.write");
    EXPECT_EQ(filesThere(), 1u) << "nothing is left beside it";
}

TEST_F(ManifestTest, WhereNothingCanBeWrittenTheErrorSaysSo) {
    for (const char* place : {"/proc/warm.manifest", "/nowhere/warm.manifest"}) {
        const Result<void> written = writeManifest(place, someUses());
        ASSERT_FALSE(written) << place;
        EXPECT_EQ(written.error().code, "manifest.write");
    }
}

/// The disk is full after so many bytes, as far as this process can tell.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit m_before{};
};

TEST_F(ManifestTest, OnAFullDiskTheOldFileStays) {
    ASSERT_TRUE(writeManifest(file(), {{use("surface")}}));
    for (const rlim_t room : {0, 1, 50, 100}) {
        Result<void> written;
        {
            const FullDisk full(room);
            written = writeManifest(file(), someUses());
        }
        ASSERT_FALSE(written) << room;
        EXPECT_EQ(written.error().code, "manifest.write");
        EXPECT_EQ(*readManifest(file()), std::vector<ProgramUse>{use("surface")});
        EXPECT_EQ(filesThere(), 1u);
    }
}

} // namespace
} // namespace franken::test
