// SPDX-License-Identifier: MIT
// What compose() says beside the text must agree with the text: the interface and the line map, read back
// here by other means than the composer's.
#include "franken/generator/compose.h"

#include "franken/generator/choices.h"
#include "franken/generator/covering.h"
#include "population.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace franken {
namespace {

using namespace test;

std::vector<std::string> linesOf(std::istream& stream) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    return linesOf(stream);
}

std::vector<Permutation> bases() {
    std::vector<Permutation> all = coveringSet();
    all.push_back(richSurface());
    return all;
}

// "uniform vec3[9] uSky lights 01": one declaration as the text or the interface has it.
using Declarations = std::multiset<std::string>;

struct FromText {
    std::string type, count = "1", block;
    bool vertex = false, fragment = false;
};

// Reads "uniform mediump vec3 uName[9]; // block: meaning" into the entry for "uniform uName".
void readDeclaration(const std::string& line, bool FromText::*stage, std::map<std::string, FromText>& found) {
    std::istringstream words(line);
    std::string kind, type, name, slashes, block;
    words >> kind >> type;
    if (type == "mediump")
        words >> type;
    words >> name >> slashes >> block;
    ASSERT_TRUE(name.ends_with(';')) << line;
    name.pop_back();
    const std::size_t bracket = std::min(name.find('['), name.size());
    FromText& entry = found[kind + " " + name.substr(0, bracket)];
    EXPECT_FALSE(entry.*stage) << name << " is declared twice";
    entry.*stage = true;
    entry.type = type;
    if (bracket < name.size())
        entry.count = name.substr(bracket + 1, name.size() - bracket - 2);
    if (kind == "uniform")
        entry.block = block.substr(0, block.find(':'));
}

Declarations declarationsInText(const Composed& program) {
    std::map<std::string, FromText> found;
    const auto read = [&](const std::string& text, bool FromText::*stage) {
        for (const std::string& line : linesOf(text))
            if (line.starts_with("attribute ") || line.starts_with("varying ") ||
                line.starts_with("uniform "))
                readDeclaration(line, stage, found);
    };
    read(program.vertex.text, &FromText::vertex);
    read(program.fragment.text, &FromText::fragment);
    Declarations declarations;
    for (const auto& [name, entry] : found)
        declarations.insert(name + " " + entry.type + "[" + entry.count + "] " + entry.block +
                            (entry.vertex ? " vertex" : "") + (entry.fragment ? " fragment" : ""));
    return declarations;
}

Declarations declarationsInInterface(const Interface& interface) {
    Declarations declarations;
    const auto add = [&](const std::string& kind, const std::string& name, Type type, int count,
                         std::string_view block, bool vertex, bool fragment) {
        declarations.insert(kind + " " + name + " " + std::string(toGlsl(type)) + "[" +
                            std::to_string(count) + "] " + std::string(block) + (vertex ? " vertex" : "") +
                            (fragment ? " fragment" : ""));
    };
    for (const Attribute& a : interface.attributes)
        add("attribute", a.name, a.type, 1, "", true, false);
    for (const Varying& v : interface.varyings)
        add("varying", v.name, v.type, 1, "", true, true);
    for (const Uniform& u : interface.uniforms)
        add("uniform", u.name, u.type, u.count, toText(u.block), u.vertex, u.fragment);
    for (const Sampler& s : interface.samplers)
        add("uniform", s.name, s.type, 1, toText(s.block), false, true);
    return declarations;
}

TEST(Compose, InterfaceIsWhatTheTextDeclares) {
    for (const Permutation& p : bases()) {
        const Composed program = compose(p);
        EXPECT_EQ(declarationsInInterface(program.interface), declarationsInText(program)) << toName(p);
    }
}

TEST(Compose, LocationsAndUnitsAreFixedAndUnique) {
    std::map<std::string, int> locations, units;
    for (const Permutation& p : bases()) {
        std::set<int> taken;
        const Interface interface = compose(p).interface;
        for (const Attribute& a : interface.attributes) {
            EXPECT_TRUE(a.location >= 0 && a.location < 8) << a.name << " " << a.location;
            EXPECT_TRUE(taken.insert(a.location).second) << a.name << " in " << toName(p);
            EXPECT_EQ(locations.try_emplace(a.name, a.location).first->second, a.location);
        }
        taken.clear();
        for (const Sampler& s : interface.samplers) {
            EXPECT_TRUE(s.unit >= 0 && s.unit < 8) << s.name << " " << s.unit;
            EXPECT_TRUE(taken.insert(s.unit).second) << s.name << " in " << toName(p);
            EXPECT_EQ(units.try_emplace(s.name, s.unit).first->second, s.unit);
        }
    }
}

const std::vector<std::string>& snippetLines(const std::string& name) {
    static std::map<std::string, std::vector<std::string>> files;
    const auto [entry, isNew] = files.try_emplace(name);
    if (isNew) {
        std::ifstream file(FRANKEN_SOURCE_DIR "/generator/glsl/" + name + ".glsl");
        EXPECT_TRUE(file) << name;
        entry->second = linesOf(file);
    }
    return entry->second;
}

std::string replaceAll(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
        text.replace(at, what.size(), with);
    return text;
}

bool isInstanceOf(const std::string& line, const std::string& pattern) {
    for (const std::string uv : {"vUv0", "vUv1"})
        for (const std::string kind : {"Sun", "Punctual"})
            for (unsigned light = 0; light < Permutation::kMaxLights; ++light) {
                std::string text = replaceAll(pattern, "${uv}", uv);
                text = replaceAll(text, "${light}", kind + std::to_string(light));
                if (replaceAll(text, "${lane}", std::string_view("xyzw").substr(light, 1)) == line)
                    return true;
            }
    return false;
}

bool isTheComposersOwn(const std::string& line) {
    return line.empty() || line == "#version 100" || line == "void main() {" || line == "}" ||
           line.starts_with("//");
}

void checkLineMap(const ComposedStage& stage, const std::string& folder) {
    const std::vector<std::string> lines = linesOf(stage.text);
    ASSERT_EQ(stage.lines.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const LineOrigin& origin = stage.lines[i];
        if (origin.snippet.empty()) {
            EXPECT_TRUE(isTheComposersOwn(lines[i])) << lines[i];
            continue;
        }
        EXPECT_TRUE(origin.snippet.starts_with(folder)) << origin.snippet;
        const std::string snippet(origin.snippet); // g++ 14 takes a temporary here for what is returned.
        const auto& file = snippetLines(snippet);
        const auto at = static_cast<std::size_t>(origin.line) - 1;
        ASSERT_LT(at, file.size()) << origin.snippet;
        ASSERT_TRUE(isInstanceOf(lines[i], file[at])) << lines[i] << "\nis not\n" << file[at];
    }
}

TEST(Compose, LineMapLeadsToTheSnippetsLines) {
    for (const Permutation& p : bases()) {
        const Composed program = compose(p);
        checkLineMap(program.vertex, "vertex/");
        checkLineMap(program.fragment, "fragment/");
    }
}

// Each flag that is on in a stage stands in its head; nothing else does.
TEST(Compose, HeadNamesTheStageAndItsFlags) {
    const std::string name = "basecolor.normal+ambient+sun1+seed+decode-none+linear";
    const Composed program = compose(named(name));
    EXPECT_TRUE(
        program.vertex.text.starts_with("#version 100\n// FrankenShader\n//   transform/position: 1\n"));
    EXPECT_TRUE(program.fragment.text.starts_with("#version 100\n// FrankenShader " + name + "\n"));
    EXPECT_NE(program.vertex.text.find("//\n// VERTEX SHADER\n//\n"), std::string::npos);
    EXPECT_NE(program.fragment.text.find("//\n// FRAGMENT SHADER\n//\n"), std::string::npos);
    EXPECT_NE(program.vertex.text.find("\n//   frame/normal: 1\n"), std::string::npos);
    EXPECT_EQ(program.vertex.text.find("//   output"), std::string::npos);
    EXPECT_EQ(program.vertex.text.find("//   brdf"), std::string::npos);
    EXPECT_NE(program.fragment.text.find("\n//   brdf: seed\n"), std::string::npos);
    EXPECT_NE(program.fragment.text.find("\n//   output: linear\n"), std::string::npos);
}

// The name in a fragment shader's head asks for this very fragment shader, whichever program it was written
// for.
TEST(Compose, TheNameInTheHeadBringsTheShaderBack) {
    for (const Permutation& p : bases()) {
        const std::string text = compose(p).fragment.text;
        const std::string line = linesOf(text).at(1);
        const std::string head = "// FrankenShader ";
        ASSERT_TRUE(line.starts_with(head)) << line;
        EXPECT_EQ(compose(named(line.substr(head.size()))).fragment.text, text) << toName(p);
    }
}

std::string kindOf(const std::string& line) {
    std::istringstream words(line);
    std::string kind, type, name, slashes, block;
    words >> kind >> type >> name >> slashes >> block;
    if (type == "mediump")
        words >> block;
    const bool sampler = type.starts_with("sampler");
    return kind == "uniform" ? (sampler ? "samplers" : block.substr(0, block.find(':'))) : kind;
}

// The kinds of declarations in a stage, in the order in which they come.
std::vector<std::string> kindsIn(const std::string& text) {
    std::vector<std::string> kinds;
    for (const std::string& line : linesOf(text))
        if (line.starts_with("attribute ") || line.starts_with("varying ") || line.starts_with("uniform "))
            if (const std::string kind = kindOf(line); kinds.empty() || kinds.back() != kind)
                kinds.push_back(kind);
    return kinds;
}

TEST(Compose, DeclarationsStandInGroups) {
    const std::vector<std::string> order = {"attribute", "varying", "frame", "lights",
                                            "material",  "object",  "skin",  "samplers"};
    for (const Permutation& p : bases()) {
        const Composed program = compose(p);
        for (const std::string* text : {&program.vertex.text, &program.fragment.text}) {
            const std::vector<std::string> kinds = kindsIn(*text);
            std::size_t at = 0;
            for (const std::string& kind : order)
                at += at < kinds.size() && kinds[at] == kind;
            EXPECT_EQ(at, kinds.size()) << toName(p);
        }
    }
}

TEST(Compose, LogsPointAtSnippets) {
    ComposedStage stage{"a\nb\nc\n", {{{}, 0}, {"fragment/brdf/ggx", 15}, {"fragment/view/view", 4}}};
    const std::string gltf = " [generator/glsl/fragment/brdf/ggx.glsl:15]\n";
    EXPECT_EQ(annotateLog("0:2(5): error: x", stage), "0:2(5): error: x" + gltf);
    EXPECT_EQ(annotateLog("ERROR: 0:2: 'x' : y", stage), "ERROR: 0:2: 'x' : y" + gltf);
    EXPECT_EQ(annotateLog("0:1(1): x\n0:3(1): y\n", stage),
              "0:1(1): x\n0:3(1): y [generator/glsl/fragment/view/view.glsl:4]\n");
    for (const std::string log : {"no line", "0:4(1): beyond", "0:99999999999999(1): far", "0:", "0:0(1): x"})
        EXPECT_EQ(annotateLog(log, stage), log + "\n");
    EXPECT_EQ(annotateLog("", stage), "");
}

} // namespace
} // namespace franken
