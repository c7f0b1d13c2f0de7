// SPDX-License-Identifier: MIT
#include "franken/generator/choices.h"
#include "kiosk/config/checks.h"
#include "kiosk/config/example.h"
#include "kiosk/config/file_watch.h"
#include "kiosk/config/read_config.h"
#include "kiosk/config/setting.h"
#include "support/shell.h"

#include <gtest/gtest.h>

namespace franken::test {
namespace {

using namespace kiosk;

std::vector<std::string> faultsOf(const std::string& text) {
    std::vector<std::string> faults;
    for (const Error& fault : parseConfig(text, "kiosk.toml", "/shop").faults)
        faults.push_back(toString(fault));
    return faults;
}

TEST(KioskConfig, TheExampleIsWhatTheTablePrints) {
    EXPECT_EQ(readText(std::string(FRANKEN_SOURCE_DIR) + "/examples/kiosk/kiosk.toml"), exampleConfig())
        << "kiosk settings >examples/kiosk/kiosk.toml";
}

TEST(KioskConfig, TheExampleHasAllSettingsAndChangesNone) {
    const ReadConfig read = parseConfig(exampleConfig(), "example", "/");
    EXPECT_TRUE(read.faults.empty()) << toString(read.faults.front());
    const Config defaults;
    for (const Setting& setting : settings()) {
        EXPECT_EQ(valueText(setting, read.config), valueText(setting, defaults)) << setting.key;
        EXPECT_NE(exampleConfig().find("\n" + nameOf(setting) + " = "), std::string::npos) << setting.key;
    }
}

TEST(KioskConfig, EverySettingIsDocumentedAndUnique) {
    std::set<std::string> keys;
    for (const Setting& setting : settings()) {
        EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
        EXPECT_TRUE(!setting.help.empty() || !sectionHelp(sectionOf(setting)).empty()) << setting.key;
    }
}

TEST(KioskConfig, ToneMapsHaveTheWordsOfPrograms) {
    std::vector<std::string> words;
    for (const Choice& choice : choices())
        if (choice.name == "toneMap")
            for (const auto& option : choice.options)
                words.emplace_back(option.word);
    EXPECT_EQ(std::get<Text>(findSetting("show.tone-map")->kind).words, words);
}

struct BadFile {
    const char* text;
    const char* fault;
};

TEST(KioskConfig, SaysWhatIsWrongWhereAndWhatWasMeant) {
    const BadFile files[] = {
        {"[screen]\nmod = \"1x1\"",
         "kiosk.toml:2:1: there is no setting screen.mod (screen.mode was probably meant)"},
        {"[sreen]\nmode = \"1x1\"", "kiosk.toml:1:2: there is no setting sreen"},
        {"[content]\n  seconds = \"30\"", "kiosk.toml:2:13: content.seconds is not a whole number"},
        {"[content]\nseconds = -1", "kiosk.toml:2:11: content.seconds is out of range: 0 to 86400"},
        {"[content]\nfade-seconds = nan", "kiosk.toml:2:16: content.fade-seconds is out of range"},
        {"[show]\ntone-map = \"neutrl\"", "\"neutral\" was probably meant"},
        {"[show]\nbackground = \"red\"", "show.background is not three numbers"},
        {"[show]\nsuns = [\"0,0,0\"]", "\"0,0,0\" has no direction"},
        {"[keys]\nnext = [\"rihgt\"]", "\"right\" was probably meant"},
        {"[buttons]\nnext = [\"17\"]", "is not GPIO and a number"},
        {"[timetable]\nmonday = [\"18:00-09:00\"]", "ends before it begins"},
        {"[timetable]\nclosed = [\"2026-02-30\"]", "is no day of the calendar"},
        {"[timetable]\nrestart = \"25:00\"", "is not a time"},
        {"[screen]\nmode = 1999-01-01", "screen.mode is of another kind"},
        {"[screen\n", "kiosk.toml:1:8: "},
        {"screen = 1", "there is no setting screen"},
    };
    for (const BadFile& file : files) {
        const std::vector<std::string> faults = faultsOf(file.text);
        ASSERT_EQ(faults.size(), 1U) << file.text;
        EXPECT_NE(faults[0].find(file.fault), std::string::npos) << faults[0];
    }
}

TEST(KioskConfig, ReportsAllFaultsAndKeepsWhatIsGood) {
    const ReadConfig read = parseConfig("[content]\nseconds = 7\nfoo = 1\n[show]\nexposure = 0\n", "f", "/");
    EXPECT_EQ(read.faults.size(), 2U);
    EXPECT_EQ(read.config.content.seconds, 7);
    EXPECT_EQ(read.config.show.exposure, 1);
}

TEST(KioskConfig, PathsAreRelativeToTheFile) {
    const ReadConfig read =
        parseConfig("[content]\nfolder = \"models\"\nplaylist = [\"a.glb\", \"/b.glb\"]\n", "f", "/shop");
    EXPECT_EQ(read.config.content.folder, "/shop/models");
    EXPECT_EQ(read.config.content.playlist, (Texts{"/shop/a.glb", "/b.glb"}));
}

TEST(KioskConfig, OptionsWinOverTheFile) {
    const std::filesystem::path file = emptyTestFolder() / "kiosk.toml";
    std::ofstream(file) << "[content]\nseconds = 7\nfade-seconds = 2\n";
    const ReadConfig read = readConfig(file, {{"content.seconds", "9"}, {"keys.next", "x space"}});
    EXPECT_TRUE(read.faults.empty());
    EXPECT_EQ(read.config.content.seconds, 9);
    EXPECT_EQ(read.config.content.fadeSeconds, 2);
    EXPECT_EQ(read.config.keys.at("next"), (Texts{"x", "space"}));
    EXPECT_EQ(readConfig(file, {{"content.seconds", "soon"}}).faults.size(), 1U);
}

TEST(KioskConfig, OneKeyHasOneAction) {
    const ReadConfig read = readConfig({}, {{"keys.next", "a"}, {"keys.pause", "a"}});
    ASSERT_EQ(read.faults.size(), 1U);
    EXPECT_EQ(read.faults[0].code, "config.twice");
}

TEST(KioskConfig, SaysWhatWaitsForARestart) {
    Config before, after;
    after.content.seconds = 3;
    after.screen.output = "DSI-1";
    EXPECT_EQ(needRestart(before, after), std::vector<std::string>{"screen.output"});
}

TEST(KioskConfig, RefusesAFileThatIsMissingOrTooLarge) {
    const std::filesystem::path file = emptyTestFolder() / "kiosk.toml";
    EXPECT_EQ(readConfig(file).faults.at(0).code, "file.open");
    std::ofstream(file) << std::string(300 << 10, '#');
    EXPECT_EQ(readConfig(file).faults.at(0).code, "file.size");
}

TEST(KioskConfig, ParsesTimesDaysAndButtons) {
    EXPECT_EQ(*parseClock("24:00"), 1440);
    EXPECT_FALSE(parseClock("24:01"));
    EXPECT_FALSE(parseClock("7:00"));
    EXPECT_EQ(parseHours("09:30-18:00")->from, 570);
    EXPECT_EQ(*parseDate("12-25"), (Date{0, 12, 25}));
    EXPECT_EQ(*parseDate("2026-02-28"), (Date{2026, 2, 28}));
    EXPECT_FALSE(parseDate("2026-2-28"));
    EXPECT_EQ(*parseButton("GPIO17:long"), (ButtonName{17, PressKind::Long}));
    EXPECT_FALSE(parseButton("GPIO17:hard"));
}

TEST(KioskCommand, CheckNamesTheFaultAndEndsWithThree) {
    const std::filesystem::path folder = emptyTestFolder();
    std::ofstream(folder / "bad.toml") << "[content]\nsecond = 7\n";
    std::ofstream(folder / "good.toml") << "[content]\nseconds = 7\n";
    const Outcome bad = runIn(folder, KIOSK " check bad.toml");
    EXPECT_EQ(bad.code, 3);
    EXPECT_NE(
        bad.err.find("bad.toml:2:1: there is no setting content.second (content.seconds was probably meant)"),
        std::string::npos)
        << bad.err;
    EXPECT_EQ(runIn(folder, KIOSK " check good.toml").code, 0);
    EXPECT_EQ(runIn(folder, KIOSK " check").code, 2);
    for (const auto& [typed, meant] :
         {std::pair("chekc", "check"), {"Doctor", "doctor"}, {"setings", "settings"}}) {
        const Outcome mistyped = runIn(folder, std::string(KIOSK " ") + typed + " good.toml");
        EXPECT_EQ(mistyped.code, 2) << typed;
        EXPECT_NE(mistyped.err.find("did you mean '" + std::string(meant) + "'?"), std::string::npos)
            << mistyped.err;
    }
    EXPECT_EQ(runIn(folder, KIOSK " settings").out, exampleConfig());
}

TEST(KioskFileWatch, WhereTheFolderCannotBeWatchedTheFileIsLookedAtAndTheLogSaysSoOnce) {
    const std::filesystem::path file = emptyTestFolder() / "later" / "kiosk.toml";
    const auto loop = EventLoop::make();
    ASSERT_TRUE(loop);
    std::string log;
    int changes = 0;
    const FileWatch watch(
        **loop, file, [&log](franken::LogLevel, std::string_view text) { log += text; },
        [&changes] { ++changes; }, std::chrono::milliseconds(1));
    EXPECT_NE(log.find("cannot be watched: No such file or directory"), std::string::npos) << log;
    std::filesystem::create_directory(file.parent_path());
    std::ofstream(file) << "new";
    while (changes == 0)
        ASSERT_TRUE((*loop)->turn());
    EXPECT_EQ(log.find("looked at"), log.rfind("looked at")) << log;
}

} // namespace
} // namespace franken::test
