// SPDX-License-Identifier: MIT
// What frankenshader offers to builds and to shells: formats, dependencies, comparisons after an upgrade,
// parts of the space that fit a GPU, completions; and what many programs cost in time and memory.
#include "cli_runner.h"

#include "franken/generator/compose.h"
#include "franken/generator/pack.h"

#include <nlohmann/json.hpp>

#include <map>

using nlohmann::json;

namespace {

const std::string kDim = "//! light\nvec3 onLight(vec3 color) {\n  return 0.5 * color;\n}\n";

class CliBuild : public Cli {
protected:
    long peakOf(const std::string& arguments) const {
        return franken::test::peakKiBIn(m_directory, kProgram + (" " + arguments));
    }
};

TEST_F(CliBuild, CountsAllAndSaysWhereItStops) {
    EXPECT_EQ(run("list --count --where sky").out, "64\n");
    EXPECT_EQ(run("list --count --where 'unlit+!double' --limit 0").out,
              run("list --count --where 'unlit+!double'").out);
    EXPECT_GT(std::stol(run("list --count --where 'unlit+!double'").out), 100);
    EXPECT_EQ(run("list --count --limit 7").out, "more than 7\n");
}

TEST_F(CliBuild, WritesACHeaderThatCompiles) {
    ASSERT_EQ(run("dump basecolor.normal+sun2 sky overlay --format c -o shaders.h").code, 0);
    EXPECT_EQ(run("dump basecolor.normal+sun2 sky overlay --format c").out, read("shaders.h"));
    std::ofstream(path("main.c")) << R"(#include "shaders.h"
#include <stdio.h>
int main(void) {
    const FrankenProgram* p = franken_programs;
    for (; p->name; ++p) {
        const FrankenUniform* u = p->uniforms;
        printf("%s %s\n", p->name, p->key);
        for (; u->name; ++u) printf("%s %s %d %d\n", u->name, u->block, u->count, u->offset);
    }
    fputs(franken_programs[0].fragment, stdout);
    return franken_program_count == 3 ? 0 : 1;
}
)";
    for (const char* compiler : {"gcc -std=c99", "g++ -x c++ -std=c++20"})
        EXPECT_EQ(
            shell(std::string(compiler) + " -Wall -Wextra -Werror main.c -o main && ./main >printed").code, 0)
            << read("err");
    const std::string printed = read("printed");
    EXPECT_NE(printed.find("sky 0x"), std::string::npos);
    const int offset = franken::fieldOffset(franken::Block::Lights, "uSun1Direction");
    ASSERT_GE(offset, 0);
    EXPECT_NE(printed.find("uSun1Direction lights 1 " + std::to_string(offset)), std::string::npos)
        << printed;
    EXPECT_TRUE(
        printed.ends_with(franken::compose(*franken::parseName("basecolor.normal+sun2")).fragment.text));
}

TEST_F(CliBuild, JsonHasTheOffsetsOfUniforms) {
    const json document = json::parse(run("dump basecolor+sun1 --format json").out);
    std::size_t uniforms = 0;
    for (const json& uniform : document["programs"][0]["interface"]["uniforms"]) {
        ++uniforms;
        EXPECT_GE(uniform["offset"].get<int>(), 0) << uniform;
    }
    EXPECT_GT(uniforms, 3u);
    ASSERT_EQ(run("dump basecolor+sun1 --format json -o one.json").code, 0);
    EXPECT_EQ(json::parse(read("one.json")), document);
    EXPECT_EQ(run("dump basecolor+sun1 --json").out, read("one.json"));
    // A piece at a time, and yet as if it were written in one.
    const std::string two = run("dump sun1 sun2 --json").out;
    EXPECT_EQ(nlohmann::ordered_json::parse(two).dump(2) + "\n", two);
}

// Its second value lies behind the first vec4, whichever of them a hook reads.
TEST_F(CliBuild, ValuesOfAnEffectHaveOffsetsToo) {
    const std::string dump =
        "dump --effects '" FRANKEN_SOURCE_DIR "/tests/golden/effects/hooks.glsl' sun1+hooks ";
    std::map<std::string, int> offsets;
    const json document = json::parse(run(dump + "--json").out);
    for (const json& uniform : document["programs"][0]["interface"]["uniforms"])
        if (uniform["block"] == "user")
            offsets[uniform["name"]] = uniform["offset"];
    EXPECT_EQ(offsets, (std::map<std::string, int>{{"uWave", 0}, {"uTint", 4}}));
    const std::string header = run(dump + "--format c").out;
    EXPECT_NE(header.find("{\"uTint\", \"vec4\", \"user\", 1, 4}"), std::string::npos) << header;
}

TEST_F(CliBuild, WritesDependencies) {
    const std::string odd = "my $names #1.txt";
    std::ofstream(path(odd)) << "sun1\n";
    ASSERT_EQ(run("dump --manifest '" + odd + "' --format c -o out.h --depfile out.d").code, 0);
    const std::string rule = read("out.d");
    EXPECT_TRUE(rule.starts_with("out.h: \\\n  my\\ $$names\\ \\#1.txt")) << rule;
    EXPECT_NE(rule.find("/bin/frankenshader"), std::string::npos);
    ASSERT_EQ(run("dump sun1 -o folder --depfile folder.d").code, 0);
    EXPECT_TRUE(read("folder.d").starts_with("folder/manifest.json:"));
    EXPECT_EQ(run("dump sun1 --depfile x.d").code, 2) << "it has no target";
    std::ofstream(path("dim.glsl")) << kDim;
    ASSERT_EQ(run("dump sun1+dim --effects dim.glsl --format c -o dim.h --depfile dim.d").code, 0);
    EXPECT_TRUE(read("dim.d").starts_with("dim.h: \\\n  dim.glsl")) << read("dim.d");
    if (shell("make --version").code == 0) {
        std::ofstream(path("Makefile")) << "out.h:\n\t@echo made\n-include out.d\n";
        EXPECT_EQ(shell("make -s out.h").out, "");
        EXPECT_EQ(shell("touch -d '1 hour' '" + odd + "' && make -s out.h").out, "made\n");
    }
}

TEST_F(CliBuild, NoOutputOverwritesAnInput) {
    for (const char* name : {"warm.txt", "made/manifest.json", "made/sun1.vert", "made/a.shader_test"}) {
        fs::create_directories(path("made"));
        std::ofstream(path(name)) << "sun1\n";
        const std::string from = "dump --manifest " + std::string(name) + " ";
        const std::string file = "./" + std::string(name);
        for (const std::string& arguments :
             {from + "--format json -o " + file, from + "--format c -o " + file,
              from + "-o other --depfile " + file}) {
            const Outcome outcome = run(arguments);
            EXPECT_EQ(outcome.code, 2) << arguments;
            EXPECT_NE(outcome.err.find("which is an input"), std::string::npos) << outcome.err;
        }
        const bool inside = file.find("made/") != std::string::npos;
        EXPECT_EQ(run(from + "-o made").code, inside ? 2 : 0) << name;
        EXPECT_EQ(read(name), "sun1\n");
        fs::remove_all(path("made"));
    }
    std::ofstream(path("dim.vert")) << kDim;
    for (const char* output : {"--format c -o dim.vert", "-o other --depfile ./dim.vert", "-o ."})
        EXPECT_EQ(run("dump sun1+dim --effects dim.vert " + std::string(output)).code, 2) << output;
    EXPECT_EQ(read("dim.vert"), kDim);
    EXPECT_EQ(run("dump sun1 --format c -o a.h --depfile a.h").code, 2);
    EXPECT_FALSE(fs::exists(path("a.h")));
}

TEST_F(CliBuild, ComparesAFolderWithToday) {
    ASSERT_EQ(run("dump sun1 basecolor+sun2 sky -o set").code, 0);
    Outcome outcome = run("diff --against set");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    std::ofstream(path("set/sun1.frag"), std::ios::app) << "// as it was\x1b[31m\n";
    outcome = run("diff --against set");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.out.find("\n-// as it was"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("3 programs compared, 1 differ"), std::string::npos) << outcome.err;
    const json document = json::parse(run("diff --against set --json").out);
    EXPECT_EQ(document["same"], false);
    EXPECT_EQ(document["programs"].size(), 3u);
    // A program of a version that had other words.
    json manifest = json::parse(read("set/manifest.json"));
    manifest["programs"][1]["name"] = "glow+sun1";
    std::ofstream(path("set/manifest.json")) << manifest;
    outcome = run("diff --against set");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.out.find("glow+sun1: there is no such program any more"), std::string::npos)
        << outcome.out;
}

TEST_F(CliBuild, RefusesAFolderThatDumpDidNotWrite) {
    fs::create_directory(path("set"));
    for (const char* text :
         {"", "[]", "{\"programs\": 1}", "{\"programs\": [1]}",
          "{\"programs\": [{\"name\": \"sun1\", \"vertex\": \"../../secret\"}]}",
          "{\"programs\": [{\"name\": \"sun1\", \"vertex\": \"a\", \"fragment\": \"b\"}]}"}) {
        std::ofstream(path("set/manifest.json")) << text;
        const Outcome outcome = run("diff --against set");
        EXPECT_EQ(outcome.code, 3) << text << outcome.err;
        EXPECT_NE(outcome.err.find("diff.folder"), std::string::npos) << outcome.err;
    }
}

TEST_F(CliBuild, ANameMayBeAKey) {
    const json listed = json::parse(run("list --where unlit --limit 3 --json").out);
    for (const json& each : listed["permutations"]) {
        const std::string key = each["key"], name = each["name"];
        EXPECT_EQ(run("dump " + key).out, run("dump " + name).out);
        writeManifest(key + "\n");
        EXPECT_EQ(run("list --manifest warm.txt").out, name + "\n");
        EXPECT_EQ(run("diff " + key + " " + name).code, 0);
        EXPECT_EQ(run("explain " + key).out, run("explain " + name).out);
    }
}

TEST_F(CliBuild, ShowsHelpAndVersionAsOthersDo) {
    EXPECT_EQ(run("help").out, run("--help").out);
    EXPECT_EQ(run("help dump").out, run("dump --help").out);
    EXPECT_EQ(run("-V").out, run("--version").out);
}

TEST_F(CliBuild, CompletesCommandsOptionsAndWords) {
    for (const char* shellName : {"bash", "zsh", "fish"}) {
        const std::string script = run(std::string("completions ") + shellName).out;
        for (const char* word : {"explain", "completions", "metalrough-separate", "against"})
            EXPECT_NE(script.find(word), std::string::npos) << shellName << ' ' << word;
        std::ofstream(path(shellName)) << script;
        if (shell(std::string("command -v ") + shellName).code == 0) {
            EXPECT_EQ(shell(std::string(shellName) + " -n " + shellName).code, 0) << read("err");
        }
    }
    const auto complete = [&](const std::string& words, int at) {
        return shell("bash -c '. ./bash; COMP_WORDS=(frankenshader " + words +
                     "); COMP_CWORD=" + std::to_string(at) + "; _frankenshader; echo ${COMPREPLY[*]}'")
            .out;
    };
    EXPECT_EQ(complete("expl", 1), "explain\n");
    EXPECT_EQ(complete("diff --aga", 2), "--against\n");
    EXPECT_EQ(complete("dump basecolor.normal+schl", 2), "basecolor.normal+schlick\n");
    EXPECT_EQ(complete("completions f", 2), "fish\n");
}

TEST_F(CliBuild, WhatFitsIsSelectedAndCovered) {
    EXPECT_EQ(run("check --covering --fits --profile vc4").code, 0) << read("out");
    EXPECT_EQ(run("check --covering --fits --profile es2-minimum --profile vc4").code, 0);
    const std::string lights = "sun4+punctual4+spots";
    EXPECT_EQ(run("list --fits --profile es2-minimum --where sh+" + lights + " --limit 1").out, "");
    EXPECT_EQ(run("dump sh+" + lights + " --fits --profile es2-minimum -o x").code, 3);
    EXPECT_EQ(run("list --profile vc4").code, 2) << "it would change nothing";
}

TEST_F(CliBuild, TenThousandProgramsTakeLittleMemory) {
    ASSERT_EQ(shell(std::string(kProgram) + " list --where lit --limit 10000 >names.txt").code, 0);
    constexpr long kLimit = 20 * 1024;
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a sanitizer's memory is not the program's";
#endif
    EXPECT_LE(peakOf("dump --manifest names.txt --format json -o all.json"), kLimit);
    EXPECT_LE(peakOf("dump --manifest names.txt --format c -o all.h"), kLimit);
    EXPECT_LE(peakOf("dump --manifest names.txt --limit 1000 -o all"), kLimit);
    EXPECT_EQ(json::parse(read("all.json"))["programs"].size(), 10000u);
    fs::remove_all(m_directory);
}

TEST_F(CliBuild, AFindingOfABatchIsOfItsProgram) {
    writeManifest("sun1\nsh+sun4+punctual4+spots\nsun2\n");
    const Outcome outcome = run("check --manifest warm.txt --profile es2-minimum");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(linesOf(outcome.out).size(), 1u) << outcome.out;
    EXPECT_NE(outcome.out.find("in sh+sun4+punctual4+spots"), std::string::npos) << outcome.out;
}

} // namespace
