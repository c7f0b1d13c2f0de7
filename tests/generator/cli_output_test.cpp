// SPDX-License-Identifier: MIT
// What frankenshader writes: texts, files, lists, JSON.
#include "cli_runner.h"
#include "franken/generator/compose.h"
#include "franken/generator/manifest.h"

#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

class CliOutput : public Cli {
protected:
    json runJson(const std::string& arguments, int code = 0) const {
        const Outcome outcome = run(arguments + " --json");
        EXPECT_EQ(outcome.code, code) << outcome.err;
        const json document = json::parse(outcome.out, nullptr, false);
        EXPECT_FALSE(document.is_discarded()) << outcome.out;
        EXPECT_EQ(document.value("schema", 0), 1);
        return document;
    }
};

TEST_F(CliOutput, DumpPrintsTheTextsAndNothingElse) {
    const franken::Composed program = franken::compose(*franken::parseName("normal+sun2"));
    EXPECT_EQ(run("dump normal+sun2").out, program.vertex.text + "\n" + program.fragment.text);
    EXPECT_EQ(run("dump normal+sun2 --stage vertex").out, program.vertex.text);
    EXPECT_EQ(run("dump normal+sun2 --stage fragment").out, program.fragment.text);
    const json document = runJson("dump normal+sun2");
    EXPECT_EQ(document["programs"][0]["fragment"], program.fragment.text);
    EXPECT_EQ(document["programs"][0]["name"], "normal+sun2");
}

TEST_F(CliOutput, DumpsAManifest) {
    writeManifest("# what the scene needs\nbasecolor.normal+sun1\n\n  sky+aces   # behind "
                  "it\r\nsun1.basecolor.normal\n");
    const Outcome outcome = run("dump --manifest warm.txt -o shaders/made/here");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    std::set<std::string> files;
    for (const auto& entry : fs::directory_iterator(path("shaders/made/here")))
        files.insert(entry.path().filename());
    const std::set<std::string> expected = {"basecolor.normal+sun1.vert",
                                            "basecolor.normal+sun1.frag",
                                            "basecolor.normal+sun1.shader_test",
                                            "sky+aces.vert",
                                            "sky+aces.frag",
                                            "sky+aces.shader_test",
                                            "manifest.json"};
    EXPECT_EQ(files, expected);
    const json manifest = json::parse(read("shaders/made/here/manifest.json"));
    ASSERT_EQ(manifest["programs"].size(), 2U) << "the third name is the first one again";
    const json& first = manifest["programs"][0];
    EXPECT_EQ(first["name"], "basecolor.normal+sun1");
    EXPECT_EQ(first["interface"]["attributes"][0]["name"], "aPosition");
    const std::string fragment = read(path("shaders/made/here") / first["fragment"].get<std::string>());
    EXPECT_EQ(fragment, run("dump basecolor.normal+sun1 --stage fragment").out);
    const std::string test = read("shaders/made/here/basecolor.normal+sun1.shader_test");
    EXPECT_NE(test.find("[fragment shader]\n" + fragment), std::string::npos);
    EXPECT_EQ(shell("printf 'sun1\\n' | " + std::string(kProgram) + " list --manifest -").out, "sun1\n");
}

TEST_F(CliOutput, AManifestThatWasCutOrIsAnotherVersionsIsRefused) {
    const std::string whole = franken::wholeManifest("sun1\nsun2\n", 2);
    writeManifest(whole);
    EXPECT_EQ(run("list --manifest warm.txt").out, "sun1\nsun2\n");
    std::string cut = whole, changed = whole, old = whole;
    cut.erase(cut.find("sun2"));
    changed.replace(changed.find("sun2"), 4, "sun3");
    old.replace(old.find("schema "), 8, "schema 1");
    for (const auto& [text, says] : {std::pair(cut, "it was cut"),
                                     {changed, "changed after it was written"},
                                     {old, "another version"}}) {
        writeManifest(text);
        const Outcome outcome = run("list --manifest warm.txt");
        EXPECT_EQ(outcome.code, 3) << text;
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
    }
}

TEST_F(CliOutput, ABadLineOfAManifestIsLocatedAndNothingIsWritten) {
    writeManifest("sun1\nbasecolor.nromal+sun1\nsun2\nspots\n");
    const Outcome outcome = run("dump --manifest warm.txt -o shaders");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.err.find("warm.txt:2: column 11: 'nromal'"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("warm.txt:4: spots"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(path("shaders")));
}

TEST_F(CliOutput, ANameTooLongForAFileBecomesAKey) {
    const std::string name =
        "basecolor.vertexcolor.metalrough-separate.normal.occlusion.emissive.blend.double.basecolor-uv1."
        "metalrough-uv1.normal-uv1.occlusion-uv1.uv0-transform.uv1-transform+ambient+sun4+punctual4+spots+"
        "schlick+"
        "decode-fast+reinhard+srgb-fast+dither+workaround-facing";
    ASSERT_GT(name.size(), 240U);
    EXPECT_EQ(run("dump " + name + " -o long").code, 0);
    const json program = json::parse(read("long/manifest.json"))["programs"][0];
    EXPECT_EQ(program["vertex"], program["key"].get<std::string>() + ".vert");
    EXPECT_TRUE(fs::exists(path("long") / program["vertex"].get<std::string>()));
}

TEST_F(CliOutput, FiltersAgree) {
    const Outcome outcome = run("list --covering --with normal --without spots --with opaque");
    EXPECT_EQ(outcome.out, run("list --covering --where 'normal+!spots,opaque'").out);
    EXPECT_FALSE(outcome.out.empty());
    for (const std::string& line : linesOf(outcome.out)) {
        EXPECT_NE(line.find("normal"), std::string::npos);
        EXPECT_EQ(line.find("spots"), std::string::npos);
        EXPECT_EQ(line.find("blend"), std::string::npos);
    }
    EXPECT_EQ(run("list --where sky --count").out, "64\n");
    EXPECT_EQ(linesOf(run("list").out).size(), 100U);
    const json document = runJson("list --limit 7");
    EXPECT_EQ(document["permutations"].size(), 7U);
    EXPECT_EQ(document["complete"], false);
    EXPECT_GT(document["product"].get<double>(), 1e12);
}

TEST_F(CliOutput, ShardsPartitionExactly) {
    for (const std::string selection : {"--covering", "--where unlit --limit 101"}) {
        const auto whole = linesOf(run("list " + selection).out);
        std::set<std::string> joined;
        std::size_t total = 0;
        for (int part = 1; part <= 4; ++part) {
            const auto lines =
                linesOf(run("list " + selection + " --shard " + std::to_string(part) + "/4").out);
            total += lines.size();
            joined.insert(lines.begin(), lines.end());
        }
        EXPECT_EQ(joined, whole) << selection;
        EXPECT_EQ(total, whole.size()) << selection;
    }
}

TEST_F(CliOutput, JsonOfEachCommandParses) {
    EXPECT_TRUE(runJson("list --words")["choices"].is_array());
    EXPECT_EQ(runJson("explain normal")["dropped"][0]["word"], "normal");
    const json explained = runJson("explain basecolor+sun1");
    EXPECT_EQ(explained["fragment"][0]["text"], "#version 100");
    EXPECT_EQ(explained["budgets"].size(), 5U);
    bool found = false;
    for (const json& line : explained["fragment"])
        found = found || (line.value("words", json()) == json::array({"basecolor", "sun1"}) &&
                          line["origin"].get<std::string>().starts_with("generator/glsl/fragment/"));
    EXPECT_TRUE(found);
    EXPECT_EQ(runJson("diff sun1 sun1")["same"], true);
    EXPECT_EQ(runJson("diff sun1 sun2", 1)["same"], false);
    const json checked = runJson("check sh+sun4+punctual4+spots --profile es2-minimum", 1);
    EXPECT_EQ(checked["findings"][0]["check"], "budget");
    EXPECT_EQ(checked["findings"][0]["where"], "es2-minimum");
}

TEST_F(CliOutput, PatchAppliesADiff) {
    if (shell("patch --version").code != 0)
        GTEST_SKIP() << "patch is not installed";
    const std::string a = "normal+sun1", b = "basecolor.normal.mask+sh+sun2+schlick+aces+dither";
    run("dump " + a + " " + b + " -o .");
    const std::string program = kProgram;
    EXPECT_EQ(shell(program + " diff " + a + " " + b + " | patch -p0 --posix").code, 0) << read("out");
    EXPECT_EQ(read(path(a + ".frag")), read(path(b + ".frag")));
    EXPECT_EQ(read(path(a + ".vert")), read(path(b + ".vert")));
}

} // namespace
