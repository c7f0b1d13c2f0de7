// SPDX-License-Identifier: MIT
// What frankenshader says to a wrong command line: what was probably meant, in words that no file can forge.
#include "cli_runner.h"

#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

using CliMistakes = Cli;

#if defined(__SANITIZE_ADDRESS__)
const std::string kAddressLimit; // A sanitizer reserves terabytes of addresses.
#else
const std::string kAddressLimit = "ulimit -v 200000 && ";
#endif

struct Mistake {
    const char* arguments;
    const char* says;
    int code = 2;
};

TEST_F(CliMistakes, OffersWhatWasProbablyMeant) {
    for (const auto& [arguments, says, code] : {
             Mistake{"lits", "did you mean 'list'?"},
             {"exlpain sun1", "did you mean 'explain'?"},
             {"help dmup", "did you mean 'dump'?"},
             {"list --wiht normal", "'--wiht' is no option of 'list' (did you mean '--with'?)"},
             {"list --limt=5", "did you mean '--limit'?"},
             {"--versoin", "did you mean '--version'?"},
             {"check sun1 --profile vc5", "did you mean 'vc4'?"},
             {"dump sun1 --stage fragmnet", "did you mean 'fragment'?"},
             {"dump sun1 --format jsno", "did you mean 'json'?"},
             {"completions bsah", "did you mean 'bash'?"},
             {"list one two three", "'one' is one argument too many for 'list'"},
             {"list --with sun5", "did you mean 'sun4'?", 3},
             {"list --where normal+sun7", "did you mean 'sun4'?", 3},
             {"dump punctual9+sun1", "did you mean 'punctual4'?", 3},
             {"dump basecolour+sun1", "did you mean 'basecolor'?", 3},
             {"dump qqqqqqqq", "list --words", 3},
             {"dump 0x12", "schema", 3},
             {"dump 0xnothing", "this is not a key", 3},
             {"diff sun1", "2 required"},
             {"diff", "--against"},
             {"LIST", "did you mean 'list'?"},
             {"-v", "'-v' is no option (did you mean '-V'?)"},
             {"dump sun1 -O x", "did you mean '-o'?"},
             {"list -x", "'-x' is no option of 'list' (see 'frankenshader list --help')"},
             {"explain --jsno", "did you mean '--json'?"},
             {"diff --agianst x", "did you mean '--against'?"},
             {"cost sun1 --gpu vc3", "did you mean 'vc4'?"},
             {"cost sun1 --max vc4", "'vc4' is not GPU=N"},
             {"cost sun1 --max vc4=0", "'vc4=0' is not GPU=N"},
             {"cost sun1 --max vc4=-1", "is not GPU=N"},
             {"cost sun1 --max vc4=99999999999999999999", "is not GPU=N"},
             {"cost sun1 --max pi3=100", "there is no such GPU"},
             {"cost sun1 --max vc4=1 --max vc4=2", "'vc4' has two limits"},
             {"cost sun1 --max vc4=1 --gpu v3d42", "'vc4' is not among the GPUs of --gpu"},
             {"cost sun1 --baseline ''", "the name is empty"},
             {"dump Normal+sun1", "did you mean 'normal'?", 3},
             {"list --limit -1", "'-1' is not a whole number"},
             {"list --limit 99999999999999999999", "is not a whole number"},
             {"list --manifest ''", "--manifest: the name is empty"},
             {"dump sun1 -o ''", "the name is empty"},
             {"diff --against ''", "the name is empty"},
             {"dump sun1 --format files", "-o DIR"},
         }) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, code) << arguments << '\n' << outcome.err;
        EXPECT_NE(outcome.err.find(says), std::string::npos) << arguments << '\n' << outcome.err;
        EXPECT_EQ(outcome.err.find("sun0"), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "") << arguments;
    }
    EXPECT_EQ(run("dump qqqqqqqq").err.find("did you mean"), std::string::npos);
}

TEST_F(CliMistakes, RefusesABaselineThatIsNone) {
    const std::string costs = R"({"command": "cost", "costs": [)";
    const std::string deep(100'000, '[');
    for (const std::string& text :
         {std::string(), std::string("no JSON"), std::string("[]"), std::string("{}"), deep, costs,
          costs + "1]}", costs + "[]]}", costs + "{}]}", costs + R"({"name": "sky"}]})",
          costs + R"({"name": "sky", "gpu": "vc4", "fragment": {"instructions": -1}}]})",
          costs + R"({"name": "sky", "gpu": "vc4", "fragment": {"instructions": 1e99}}]})",
          costs + R"({"name": "sky", "gpu": "vc4", "fragment": {"instructions": 9999999999}}]})",
          costs + R"({"name": ")" + std::string(5000, 'x') + R"(", "gpu": "vc4"}]})",
          std::string(R"({"command": "list", "costs": []})"),
          std::string(R"({"command": "cost", "costs": {}})")}) {
        std::ofstream(path("costs.json")) << text;
        const Outcome outcome = run("cost sky --baseline costs.json");
        EXPECT_EQ(outcome.code, 3) << text.substr(0, 200);
        EXPECT_NE(outcome.err.find("costs.json: "), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("cost --json"), std::string::npos) << outcome.err;
    }
    for (const char* file : {"nowhere.json", "."})
        EXPECT_EQ(run(std::string("cost sky --baseline ") + file).code, 3) << file;
}

TEST_F(CliMistakes, AnErrorIsADocumentWhereOneIsAskedFor) {
    writeManifest("sun1\nnromal\n\nsum1\n");
    struct Row {
        const char *arguments, *code;
        std::size_t count = 1;
    };
    for (const auto& [arguments, code, count] : {
             Row{"explain nromal --json", "permutation.unknown-word"},
             {"dump --format json --manifest warm.txt", "permutation.unknown-word", 2},
             {"check --manifest nowhere.txt --json", "manifest.read"},
             {"list --json --wiht normal", "usage"},
             {"lits --json", "usage"},
             {"diff --json sun1", "usage"},
             {"dump sun1 --format=json -o warm.txt/below", "file.write"},
             {"check --where sky+sun1 --json", "selection.empty"},
         }) {
        const Outcome outcome = run(arguments);
        EXPECT_GE(outcome.code, 2) << arguments;
        EXPECT_NE(outcome.err, "") << arguments;
        const json document = json::parse(outcome.out, nullptr, false);
        ASSERT_TRUE(document.is_object()) << arguments << outcome.out;
        EXPECT_EQ(document["schema"], 1);
        ASSERT_EQ(document["errors"].size(), count) << arguments << outcome.out;
        EXPECT_EQ(document["errors"][0]["code"], code) << arguments;
    }
}

TEST_F(CliMistakes, NothingToDoIsNotSuccess) {
    for (const char* arguments :
         {"check --manifest - </dev/null", "check --manifest warm.txt", "check --where sky+sun1",
          "dump --manifest warm.txt -o out", "cost --where overlay+normal", "list --manifest warm.txt"}) {
        writeManifest("# nothing yet\n");
        EXPECT_EQ(run(arguments).code, 3) << arguments;
    }
    writeManifest("sun1\n");
    EXPECT_EQ(run("check --manifest warm.txt --shard 2/2").code, 0) << "a part may be empty";
    EXPECT_EQ(run("list --where sky+sun1").code, 0) << "a list may be empty";
}

TEST_F(CliMistakes, NothingSteersTheTerminal) {
    const std::string steering = "a\x1b[31m\x9b\xc2\x9b"
                                 "31m\xe2\x80\xae";
    const auto isClean = [](const std::string& text) {
        for (const char* bad : {"\x1b", "\x9b", "\xc2\x9b", "\xe2\x80\xae", "\r", "\x07"})
            if (text.find(bad) != std::string::npos)
                return false;
        return true;
    };
    writeManifest(steering + "\n" + steering + "=\x07\nsun1 wrap0=" + steering + "\nnromal\r\x1b[2J\n");
    const std::string quoted = "'" + steering + "'";
    for (const std::string& arguments : std::vector<std::string>{
             "dump " + quoted, "dump 'sun1\nfrankenshader: error: forged'", "list --with " + quoted,
             "list --where " + quoted, "list --manifest warm.txt", "list --manifest " + quoted, quoted,
             "list --" + quoted, "list --limit " + quoted, "check sun1 --profile " + quoted, "help " + quoted,
             "dump sun1 -o warm.txt/" + quoted, "diff --against " + quoted, "dump 0x" + quoted,
             "explain --json " + quoted}) {
        const Outcome outcome = run(arguments);
        EXPECT_GE(outcome.code, 2) << arguments;
        EXPECT_TRUE(isClean(outcome.err)) << outcome.err;
        EXPECT_TRUE(isClean(outcome.out)) << outcome.out;
        EXPECT_EQ(outcome.err.find("\nfrankenshader: error: forged"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(run("dump sun1 -o " + quoted).code, 0);
    EXPECT_TRUE(isClean(run("dump sun1 -o " + quoted).err));
}

TEST_F(CliMistakes, ShowsTwentyErrorsAndCountsTheRest) {
    std::string names;
    for (int i = 0; i < 100; ++i)
        names += "nromal\n";
    writeManifest(names);
    const Outcome outcome = run("list --manifest warm.txt");
    EXPECT_NE(outcome.err.find("warm.txt:20:"), std::string::npos);
    EXPECT_EQ(outcome.err.find("warm.txt:21:"), std::string::npos);
    EXPECT_NE(outcome.err.find("and 80 more errors"), std::string::npos) << outcome.err;
}

TEST_F(CliMistakes, SaysWhyADroppedWordMatters) {
    EXPECT_NE(run("dump basecolor").err.find("drawn black; add 'sun1'"), std::string::npos);
    EXPECT_NE(run("dump normal+ambient").err.find("add 'sun1'"), std::string::npos);
    EXPECT_NE(run("dump normal+unlit").err.find("leave 'unlit' out"), std::string::npos);
}

TEST_F(CliMistakes, TakesAByteOrderMark) {
    writeManifest("\xEF\xBB\xBFsun1\r\nsun2\r\n");
    EXPECT_EQ(run("list --manifest warm.txt").out, "sun1\nsun2\n");
    writeManifest("\xEF\xBB\xBF# a comment\nsun1\n");
    EXPECT_EQ(run("list --manifest warm.txt").out, "sun1\n");
}

// As long as a manifest may be, and nothing that is in one.
TEST_F(CliMistakes, ComparesAFolderInLittleMemory) {
    const auto times = [](std::size_t count, const std::string& text) {
        std::string all;
        while (all.size() < count * text.size())
            all += text;
        return all;
    };
    constexpr std::size_t kMany = 10'000'000;
    std::filesystem::create_directory(path("set"));
    for (const auto& [text, says] : {
             std::pair{times(kMany, "["), "nests deeper"},
             {"{\"programs\": [" + times(kMany, "{},") + "{}]}", "more programs than a folder has"},
             {"{\"programs\": [" + times(kMany, "[],") + "[]]}", "what is no program"},
             {"{\"programs\": [{\"name\": \"" + times(kMany, "x") + "\"}]}", "longer than a path"},
         }) {
        std::ofstream(path("set/manifest.json")) << text;
        const Outcome outcome =
            shell(kAddressLimit + "exec " + std::string(kProgram) + " diff --against set");
        EXPECT_EQ(outcome.code, 3) << says;
        EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err.substr(0, 1000);
    }
}

TEST_F(CliMistakes, ReadsNoMoreThanAListOfNamesHas) {
    const auto memoryOf = [&](const std::string& arguments) {
        const Outcome outcome = shell(kAddressLimit + "exec " + std::string(kProgram) + " " + arguments);
        EXPECT_EQ(outcome.code, 3) << arguments << outcome.err;
        EXPECT_NE(outcome.err.find("manifest.size"), std::string::npos) << outcome.err;
    };
    std::string names;
    while (names.size() < 20'000'000)
        names += "sun1\n";
    writeManifest(names);
    memoryOf("list --manifest warm.txt");
    memoryOf("list --manifest - <warm.txt");
    if (shell("mknod zero c 1 5 && head -c 1 zero >/dev/null").code == 0)
        memoryOf("list --manifest zero");
    EXPECT_EQ(shell("printf 'sun1\\n' | " + std::string(kProgram) + " list --manifest /dev/stdin").out,
              "sun1\n");
}

} // namespace
