// SPDX-License-Identifier: MIT
// How frankenshader speaks: exit codes, messages, colours, help.
#include "cli_runner.h"

namespace {

struct ExitRow {
    const char* arguments;
    int code;
    const char* says; ///< On standard error.
};

const ExitRow kExits[] = {
    {"dump sun1", 0, ""},
    {"explain sun1", 0, ""},
    {"diff sun1 sun1", 0, ""},
    {"diff sun1 sun2", 1, ""},
    {"check sun1 --profile all", 0, "1 programs checked, 0 findings"},
    {"check sh+sun4+punctual4+spots --profile es2-minimum", 1, "1 findings"},
    {"", 2, "A command"},
    {"lits", 2, "lits"},
    {"list --frobnicate", 2, "--frobnicate"},
    {"list --shard 3/2", 2, "3/2"},
    {"list --limit many", 2, "many"},
    {"dump", 2, "NAME"},
    {"dump sun1 sun2", 2, "-o DIR"},
    {"dump sun1 --covering", 2, "excludes"},
    {"dump sun1 --stage geometry", 2, "geometry"},
    {"check sun1 --profile vc5", 2, "vc5"},
    {"list --with sun1 --with sun2", 3, "no value is left for suns"},
    {"list --manifest nowhere.txt", 3, "nowhere.txt"},
    {"list --manifest .", 3, "directory"},
    {"dump occlusion-packed+sun1", 3, "metalrough"},
    {"diff sun1 sum1", 3, "sun1"},
    {"dump sun1 -o warm.txt/below", 4, "warm.txt/below"},
};

TEST_F(Cli, ExitCodesAndMessages) {
    writeManifest("sun1\n");
    for (const ExitRow& row : kExits) {
        const Outcome outcome = run(row.arguments);
        EXPECT_EQ(outcome.code, row.code) << row.arguments << '\n' << outcome.err;
        EXPECT_NE(outcome.err.find(row.says), std::string::npos) << row.arguments << '\n' << outcome.err;
        if (row.code >= 2) {
            EXPECT_EQ(outcome.out, "") << row.arguments;
        }
    }
    EXPECT_EQ(shell(std::string(kProgram) + " list >/dev/full").code, 4);
}

TEST_F(Cli, PointsAtTheWrongWordAndOffersTheNearestRightOne) {
    const Outcome outcome = run("dump basecolor.nromal+sun1");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("  basecolor.nromal+sun1\n            ^^^^^^ (did you mean 'normal'?)"),
              std::string::npos)
        << outcome.err;
}

TEST_F(Cli, SaysWhatItDroppedOnStandardError) {
    const Outcome outcome = run("dump normal+no-ambient");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.err.find("'normal' is dropped: there is nothing to light it"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.out, run("dump surface").out);
}

TEST_F(Cli, ColorsOnATerminalAloneAndNeverWithNoColor) {
    if (shell("command -v script").code != 0)
        GTEST_SKIP() << "script, which makes a terminal, is not installed";
    const auto onTerminal = [&](const std::string& variables) {
        return shell(variables + " script -qec '" + kProgram + " explain sun1' /dev/null").out;
    };
    EXPECT_EQ(run("explain sun1").out.find('\033'), std::string::npos);
    EXPECT_NE(onTerminal("env -u NO_COLOR TERM=xterm").find('\033'), std::string::npos);
    EXPECT_EQ(onTerminal("NO_COLOR=1 TERM=xterm").find('\033'), std::string::npos);
    EXPECT_EQ(onTerminal("env -u NO_COLOR TERM=dumb").find('\033'), std::string::npos);
}

TEST_F(Cli, HelpHasAnExampleAndTheManPageNamesEverything) {
    std::string page = run("manual " FRANKEN_SOURCE_DIR "/generator/cli/frankenshader.1.in").out;
    for (std::size_t at = 0; (at = page.find("\\-", at)) != std::string::npos;)
        page.erase(at, 1);
    const std::string help = run("--help").out;
    std::istringstream commands(help.substr(help.find("Subcommands:") + 12));
    std::size_t count = 0;
    for (std::string line; std::getline(commands, line) && (line.empty() || line.starts_with("  "));) {
        std::string command;
        if (!(std::istringstream(line) >> command))
            continue;
        ++count;
        EXPECT_NE(page.find(".B " + command + "\n"), std::string::npos) << command;
        const std::string text = run(command + " --help").out;
        EXPECT_NE(text.find("Example: frankenshader " + command), std::string::npos) << command;
        std::istringstream words(text);
        for (std::string word; words >> word;)
            if (const std::size_t dashes = word.find("--"); dashes == 0 || word.starts_with("-o,")) {
                const std::string option = word.substr(dashes, word.find_first_of("',", dashes) - dashes);
                EXPECT_NE(page.find(option), std::string::npos) << command << ' ' << option;
            }
    }
    EXPECT_GE(count, 5U);
    const std::string version = FRANKEN_VERSION;
    EXPECT_EQ(run("--version").out, "frankenshader " + version + "\ninterface " +
                                        version.substr(0, version.rfind('.')) + ", keys 2, texts 1\n");
}

TEST_F(Cli, CheckSaysWhereGlslangIsMissing) {
    // A folder of that name is refused like a folder of PATH that may not be searched.
    fs::create_directories(path("refused/glslangValidator"));
    for (const std::string& folder : {std::string("/nonexistent"), path("refused").string()}) {
        const Outcome outcome = shell("PATH=" + folder + " " + std::string(kProgram) + " check sun1");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("not installed"), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST_F(Cli, CheckSaysWhereGlslangMayNotBeRun) {
    fs::create_directories(path("locked"));
    std::ofstream(path("locked/glslangValidator")) << "no program";
    const Outcome outcome =
        shell("PATH=" + path("locked").string() + " " + std::string(kProgram) + " check sun1");
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("Permission denied"), std::string::npos) << outcome.err;
}

} // namespace
