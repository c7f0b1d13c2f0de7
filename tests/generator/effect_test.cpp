// SPDX-License-Identifier: MIT
// Effects of an application's: their texts, names and keys, and the programs that have them.
#include "franken/generator/compose.h"
#include "franken/generator/effect.h"
#include "franken/generator/explain.h"
#include "franken/generator/ladder.h"
#include "franken/generator/lint.h"

#include "support/shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace franken {
namespace {

std::string textOf(const char* file) { return test::readText(std::string(FRANKEN_SOURCE_DIR "/") + file); }

const std::string kFog = textOf("examples/effects/fog.glsl"), kRim = textOf("examples/effects/rim.glsl");
const std::string kAll = textOf("tests/golden/effects/hooks.glsl");

SnippetSet setWith(const char* name, const std::string& text) {
    const Result<Effect> effect = Effect::parse(name, text, std::string(name) + ".glsl");
    EXPECT_TRUE(effect) << toString(effect.error());
    const Result<SnippetSet> set = SnippetSet::builtIn().with(*effect);
    EXPECT_TRUE(set) << toString(set.error());
    return *set;
}

Permutation canonical(const char* name, const SnippetSet& set) {
    const Result<Permutation> parsed = parseName(name, set);
    EXPECT_TRUE(parsed) << name << ": " << toString(parsed.error());
    const Result<Canonical> result = canonicalise(*parsed);
    EXPECT_TRUE(result) << name;
    return result->permutation;
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Effect, HasItsNameAndTheHashOfItsTextInTheNamesOfPrograms) {
    const SnippetSet set = setWith("fog", kFog);
    const Permutation foggy = canonical("basecolor+sun1+fog", set);
    EXPECT_EQ(toName(foggy, set), "basecolor+sun1+" + set.effects()[0].word());
    EXPECT_TRUE(set.effects()[0].word().starts_with("fog@"));
    EXPECT_EQ(set.effects()[0].word().size(), 12u);
    const Result<Permutation> again = parseName(toName(foggy, set), set);
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, foggy);
    EXPECT_EQ(toName(canonical("fog", set), set), set.effects()[0].word()) << "alone";
    EXPECT_EQ(toName(foggy), "basecolor+sun1+effect#1") << "of a set that has not got it";
}

TEST(Effect, HasTheSameHashWithAByteOrderMark) {
    const Result<Effect> marked = Effect::parse("fog", "\xEF\xBB\xBF" + kFog, "fog.glsl");
    ASSERT_TRUE(marked);
    EXPECT_EQ(marked->hash(), setWith("fog", kFog).effects()[0].hash());
}

TEST(Effect, IsASlotInTheKey) {
    const SnippetSet one = setWith("fog", kFog);
    const Result<SnippetSet> two = one.with(*Effect::parse("rim", kRim, "rim.glsl"));
    ASSERT_TRUE(two);
    const Key without = toKey(canonical("basecolor+sun1", *two));
    std::set<Key> keys = {without};
    for (const char* name : {"basecolor+sun1+fog", "basecolor+sun1+rim"}) {
        const Permutation permutation = canonical(name, *two);
        const Key key = toKey(permutation);
        EXPECT_TRUE(keys.insert(key).second);
        const Result<Permutation> read = fromKey(key, *two);
        ASSERT_TRUE(read);
        EXPECT_EQ(*read, permutation);
        const Result<Permutation> elsewhere = fromKey(key);
        ASSERT_FALSE(elsewhere);
        EXPECT_EQ(elsewhere.error().code, "effect.missing");
    }
    const SnippetSet again = *two->with(*Effect::parse("fog", kFog + "// more\n", "fog.glsl"));
    EXPECT_EQ(again.chooseEffect("fog")->slot, 1) << "another text keeps its slot";
    EXPECT_EQ(again.chooseEffect("rim")->slot, 2);
    EXPECT_NE(again.effects()[0].hash(), one.effects()[0].hash());
}

TEST(Effect, ThatIsMissingOrHasAnotherTextIsToldByName) {
    const SnippetSet set = setWith("fog", kFog);
    const Result<Permutation> missing = parseName("sun1+smoke@00000000", set);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, "effect.missing");
    EXPECT_TRUE(contains(missing.error().what, "'smoke'"));
    const Result<Permutation> changed = parseName("sun1+fog@00000000", set);
    ASSERT_FALSE(changed);
    EXPECT_EQ(changed.error().code, "effect.changed");
    EXPECT_TRUE(contains(changed.error().remedy, set.effects()[0].word()));
    EXPECT_EQ(parseName("sun1+fog+fog", set).error().code, "permutation.twice");
    EXPECT_EQ(parseName("sun1+fog").error().code, "permutation.unknown-word");
    for (const char* word : {"sun1+smoke@0000000", "sun1+smoke@000000000", "sun1+smoke@0000000g"})
        EXPECT_EQ(parseName(word, set).error().code, "permutation.unknown-word") << word;
}

TEST(Effect, StandsInTheProgramWhereItsHookIs) {
    const SnippetSet set = setWith("fog", kFog);
    const Composed program = compose(canonical("basecolor+sun1+aces+fog", set), set);
    const std::string& text = program.fragment.text;
    const std::size_t call = text.find("  color = onLight(color, toEye);\n");
    ASSERT_NE(call, std::string::npos) << text;
    EXPECT_LT(text.find("sum.specular;"), call);
    EXPECT_LT(call, text.find("color = toneMap"));
    EXPECT_TRUE(contains(
        text, "uniform vec4 uFog; // user: linear colour, in the units of exposed light; density, 1/m\n"));
    EXPECT_TRUE(contains(text, "//   effect: fog\n"));
    const auto fog = std::find_if(program.interface.uniforms.begin(), program.interface.uniforms.end(),
                                  [](const Uniform& uniform) { return uniform.name == "uFog"; });
    ASSERT_NE(fog, program.interface.uniforms.end());
    EXPECT_EQ(fog->block, Block::User);
    EXPECT_EQ(compose(canonical("basecolor+sun1+aces+fog", set)).fragment.text,
              compose(canonical("basecolor+sun1+aces", set)).fragment.text)
        << "a set that has not got it leaves it out";
}

TEST(Effect, MapsItsLinesToItsFile) {
    const SnippetSet set = setWith("fog", kFog);
    const ComposedStage stage = compose(canonical("sun1+fog", set), set).fragment;
    const auto call = stage.text.begin() + static_cast<std::ptrdiff_t>(stage.text.find("  return mix("));
    const auto line = 1 + std::count(stage.text.begin(), call, '\n');
    const std::string log = annotateLog("0:" + std::to_string(line) + "(3): error: no", stage);
    EXPECT_TRUE(contains(log, "[fog.glsl:8]")) << log;
}

TEST(Effect, FillsAllHooksInProgramsThatAreStrictGlsl) {
    const SnippetSet set = setWith("all", kAll);
    for (const char* name :
         {"all", "unlit+all", "ambient+all", "sh+all", "sun1+all", "sun2+vertexlight+all", "normal+sun1+all",
          "skin3+sun1+all", "basecolor.metalrough.normal.occlusion-packed+sh+reflection+sun1+punctual1+all",
          "mask+all", "metalrough-separate.double+sun1+vc4+all", "metalrough+sun1+fp16+seed+all",
          "sun1+view-normal+all", "basecolor+unlit+all", "blend+sun1+fast+workaround-facing.double+all"}) {
        const Composed program = compose(canonical(name, set), set);
        for (const LintFinding& finding : lintProgram(program))
            ADD_FAILURE() << name << ": " << toString(finding);
        EXPECT_TRUE(contains(program.vertex.text, "onVertex(position)")) << name;
    }
    const Composed lit = compose(canonical("sun1+all", set), set);
    for (const char* call :
         {"  base = onBaseColor(base);", "  onSurface(normal, roughness);", "  color = onLight(color);"})
        EXPECT_TRUE(contains(lit.fragment.text, call)) << call;
    EXPECT_EQ(lit.interface.uniforms.size(),
              compose(canonical("sun1+metalrough", set), set).interface.uniforms.size() + 2);
    for (const Uniform& uniform : lit.interface.uniforms)
        if (uniform.block == Block::User) {
            EXPECT_EQ(uniform.value, uniform.name == "uTint" ? 1 : 0) << uniform.name;
        }
}

TEST(Effect, IsDroppedWhereItChangesNothing) {
    const SnippetSet fog = setWith("fog", kFog);
    for (const char* name : {"sky+fog", "overlay+fog", "sun1+view-normal+fog"}) {
        const Result<Canonical> result = canonicalise(*parseName(name, fog));
        ASSERT_TRUE(result) << name;
        EXPECT_EQ(result->permutation.effect, EffectChoice{}) << name;
        EXPECT_TRUE(std::any_of(result->dropped.begin(), result->dropped.end(), [](const Dropped& dropped) {
            return dropped.word == "effect" && contains(dropped.reason, "no hook");
        })) << name;
    }
    const Result<Canonical> perVertex = canonicalise(*parseName("sun1+vertexlight+fog", fog));
    ASSERT_EQ(perVertex->dropped.size(), 1u);
    EXPECT_EQ(perVertex->dropped[0].word, "vertexlight");
}

TEST(Effect, SharesItsVertexShaderWithOthersUnlessItMovesVertices) {
    const SnippetSet rim = setWith("rim", kRim), all = setWith("all", kAll);
    EXPECT_EQ(stageKey(canonical("sun1+rim", rim), Stage::Vertex),
              stageKey(canonical("sun1", rim), Stage::Vertex));
    EXPECT_NE(stageKey(canonical("sun1+rim", rim), Stage::Fragment),
              stageKey(canonical("sun1", rim), Stage::Fragment));
    EXPECT_NE(stageKey(canonical("sun1+all", all), Stage::Vertex),
              stageKey(canonical("sun1", all), Stage::Vertex));
}

TEST(Effect, IsWhatTheLadderTakesAwayFirst) {
    const SnippetSet set = setWith("rim", kRim);
    const std::optional<Permutation> next = simpler(canonical("normal+sun1+vc4+dither+rim", set));
    ASSERT_TRUE(next);
    EXPECT_EQ(toName(*next, set), toName(canonical("normal+sun1+vc4+dither", set), set));
    const std::optional<Permutation> unlit = simpler(canonical("normal+unlit+rim", set));
    ASSERT_TRUE(unlit);
    EXPECT_EQ(toName(*unlit, set), "unlit") << "the normal map was there for the effect alone";
}

TEST(Effect, IsExplained) {
    const SnippetSet set = setWith("rim", kRim);
    bool called = false, told = false;
    for (const Reason& reason : explain(canonical("sun1+rim", set), set)) {
        called = called || (reason.snippet == "fragment/effect/light" && toText(reason) == "rim");
        told = told || (reason.snippet == "rim.glsl" && toText(reason) == "rim");
    }
    EXPECT_TRUE(called && told);
}

struct Refused {
    const char* name;
    std::string text;
    const char* code;
    const char* where;
    const char* what;
};
const std::string kLight = "//! light\nvec3 onLight(vec3 color) {\n  return color;\n}\n";

const Refused kRefused[] = {
    {"Fog", kLight, "effect.name", "Fog", "called"},
    {"", kLight, "effect.name", "", "called"},
    {"1st", kLight, "effect.name", "1st", "called"},
    {"a-name-of-thirty-three-characters", kLight, "effect.name", "a-name-of-thirty-three-character",
     "called"},
    {"aces", kLight, "effect.name", "aces", "toneMap"},
    {"fog", "", "effect.syntax", "x.glsl:1", "no hook"},
    {"fog", "//! lights\n", "effect.syntax", "x.glsl:1", "'lights' is no hook"},
    {"fog", "float f;\n" + kLight, "effect.syntax", "x.glsl:1", "before the first section"},
    {"fog", kLight + kLight, "effect.syntax", "x.glsl:5", "there already"},
    {"fog", "#version 300 es\n" + kLight, "effect.text", "x.glsl:1", "'#version 300 es'"},
    {"fog", "//! light\n#define A 1\n", "effect.text", "x.glsl:2", "#define"},
    {"fog", std::string(17 << 10, '\n') + kLight, "effect.text", "x.glsl", "16 KiB"},
    {"fog", "//! declarations\nuniform vec3 uFog; // user: x\n" + kLight, "effect.uniform", "x.glsl:2",
     "uFog"},
    {"fog", "//! declarations\nuniform vec4 uFog; // frame: x\n" + kLight, "effect.uniform", "x.glsl:2",
     "uFog"},
    {"fog", "//! declarations\nuniform vec4 uFog; // user: x\n" + kLight, "effect.uniform", "x.glsl:2",
     "not used"},
    {"fog", "//! declarations\nuniform vec4 uFog[2]; // user: x\n" + kLight, "effect.uniform", "x.glsl:2",
     "not one"},
    {"fog", "//! declarations\nvarying vec3 vFog;\n" + kLight, "effect.uniform", "x.glsl:2", "nowhere"},
    {"fog",
     "//! declarations\nvarying vec3 vFog;\n//! light\nvec3 onLight(vec3 color) {\n  return color + "
     "vFog;\n}\n",
     "effect.uniform", "x.glsl:2", "nowhere"},
    {"fog",
     "//! declarations\nuniform vec4 uA; // user: x\nuniform vec4 uB; // user: x\nuniform vec4 uC; // "
     "user: x\n"
     "uniform vec4 uD; // user: x\nuniform vec4 uE; // user: x\n" +
         kLight,
     "effect.uniform", "x.glsl:6", "too many"},
    {"fog", "//! declarations\nuniform vec4 uA; // user: x\nuniform vec4 uA; // user: x\n" + kLight,
     "effect.uniform", "x.glsl:3", "there already"},
    {"fog", "//! declarations\nuniform vec4 uBaseColor; // user: x\n" + kLight, "effect.clash", "x.glsl:2",
     "uBaseColor"},
    {"fog", "//! light\nfloat reciprocal(float x) {\n  return x;\n}\n", "effect.clash", "x.glsl:2",
     "reciprocal"},
    {"fog", "//! light\nfloat mix(float x) {\n  return x;\n}\n", "effect.clash", "x.glsl:2", "mix"},
    {"fog", "//! light\nfloat gl_fog(float x) {\n  return x;\n}\n", "effect.clash", "x.glsl:2", "gl_fog"},
    {"fog", "//! light\nstruct Surface {\n  float x;\n};\n", "effect.clash", "x.glsl:2", "Surface"},
    {"fog", "//! light\nvec3 fog(vec3 color) {\n  return color;\n}\n", "effect.function", "x.glsl:1",
     "onLight"},
    {"fog", "//! light\nvec4 onLight(vec3 color) {\n  return color;\n}\n", "effect.signature", "x.glsl:2",
     "return vec3"},
    {"fog", "//! light\nvec3 onLight(vec3 colour) {\n  return colour;\n}\n", "effect.signature", "x.glsl:2",
     "vec3 colour"},
    {"fog", "//! light\nvec3 onLight(vec3 normal) {\n  return normal;\n}\n", "effect.signature", "x.glsl:2",
     "first"},
    {"fog", "//! light\nvec3 onLight() {\n  return vec3(0.0);\n}\n", "effect.signature", "x.glsl:2", "first"},
    {"fog", "//! surface\nvoid onSurface(vec3 toEye) {\n}\n", "effect.signature", "x.glsl:2",
     "changes nothing"},
    {"fog", "//! light\nuniform vec4 uFog;\n" + kLight.substr(10), "effect.syntax", "x.glsl:2",
     "uniform uFog"},
};

TEST(Effect, FromOutsideIsCheckedBeforeAnyCompiler) {
    for (const Refused& row : kRefused) {
        const Result<Effect> effect = Effect::parse(row.name, row.text, "x.glsl");
        ASSERT_FALSE(effect) << row.text;
        EXPECT_EQ(effect.error().code, row.code) << row.text;
        EXPECT_EQ(effect.error().where, row.where) << row.text;
        EXPECT_TRUE(contains(effect.error().what, row.what)) << effect.error().what;
        EXPECT_FALSE(effect.error().remedy.empty());
    }
}

TEST(Effect, ThatIsNoStrictGlslIsRefusedWithItsLine) {
    const std::string text = "//! light\nvec3 onLight(vec3 color) {\n  return color * 2;\n}\n";
    const Result<Effect> effect = Effect::parse("bright", text, "effects/bright.glsl");
    ASSERT_TRUE(effect);
    const Result<SnippetSet> set = SnippetSet::builtIn().with(*effect);
    ASSERT_FALSE(set);
    EXPECT_EQ(set.error().code, "effect.glsl");
    EXPECT_EQ(set.error().where, "effects/bright.glsl:3");
    EXPECT_TRUE(contains(set.error().what, "[integer-literal]"));
}

// Functions of one name with other parameters are GLSL.
TEST(Effect, ThatHasAFunctionTwiceIsRefusedWithItsLine) {
    const std::string surface = "//! surface\nfloat wet(float x) {\n  return x;\n}\n"
                                "void onSurface(inout float roughness) {\n  roughness = wet(roughness);\n}\n";
    const std::string light = "vec3 onLight(vec3 color) {\n  return wet(0.5) * color;\n}\n";
    const auto add = [&](const std::string& helper) {
        return SnippetSet::builtIn().with(
            *Effect::parse("wet", surface + "//! light\n" + helper + light, "wet.glsl"));
    };
    const Result<SnippetSet> twice = add("float wet(float y) {\n  return 0.5 * y;\n}\n");
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().where, "wet.glsl:9");
    EXPECT_TRUE(contains(twice.error().what, "'wet' is declared twice"));
    EXPECT_TRUE(add("vec3 wet(vec3 y) {\n  return wet(y.x) * y;\n}\n"));
}

TEST(Effect, HasRoomForSixtyThree) {
    SnippetSet set = SnippetSet::builtIn();
    for (int i = 1; i <= EffectChoice::kMaxSlot + 1; ++i) {
        const Result<SnippetSet> more =
            set.with(*Effect::parse("rim-" + std::to_string(i), kRim, "rim.glsl"));
        ASSERT_EQ(more.has_value(), i <= EffectChoice::kMaxSlot) << i;
        if (more)
            set = *more;
        else
            EXPECT_EQ(more.error().code, "effect.many");
    }
    const Permutation last = canonical("sun1+rim-63", set);
    EXPECT_EQ(*fromKey(toKey(last), set), last);
}

TEST(Effect, ThatIsNoneIsRefused) {
    Permutation permutation;
    for (const EffectChoice wrong :
         {EffectChoice{64, kLightHook}, EffectChoice{1, 0}, EffectChoice{0, kLightHook},
          EffectChoice{1, kLightReadsNormal}, EffectChoice{1, 0x4001}}) {
        permutation.effect = wrong;
        EXPECT_EQ(checkedKey(permutation).error().code, "permutation.range");
        EXPECT_EQ(canonicalise(permutation).error().code, "permutation.range");
    }
}

} // namespace
} // namespace franken
