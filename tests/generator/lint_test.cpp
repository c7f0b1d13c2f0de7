// SPDX-License-Identifier: MIT
// Each rule of the lint must be able to fail: a good program is spoilt in one place, and the lint must name
// that rule, that stage and that line.
#include "franken/generator/lint.h"

#include <gtest/gtest.h>

#include <set>

namespace franken {
namespace {

constexpr std::string_view kVertex = R"(#version 100
attribute vec3 aPosition;
attribute vec2 aUv;
uniform mat4 uModel;
uniform mediump vec3 uSun;
varying vec2 vUv;
varying vec3 vSun;
void main() {
  vUv = aUv;
  vSun = uSun;
  gl_Position = uModel * vec4(aPosition, 1.0);
}
)";

constexpr std::string_view kFragment = R"(#version 100
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
uniform sampler2D uTexture[2];
uniform mediump vec3 uSun;
uniform vec3 uSky[9];
uniform mat3 uTurn;
varying vec2 vUv;
varying vec3 vSun;
struct Surface {
  float alpha; // 0-1
};
const int kTerms = 9;

vec3 skyLight(vec3 n, inout float sum) {
  vec3 light = uSky[0];
  for (int i = 1; i < kTerms; ++i) light += uSky[i] * n.y;
  sum += light.x;
  return light;
}

void main() {
  float sum = 0.0, x;
  Surface surface = Surface(0.5);
  vec4 base = texture2D(uTexture[1], vUv);
  vec3 n = normalize(uTurn * vSun + uSun);
  x = surface.alpha;
  base.rgb *= skyLight(n, sum) * x;
  gl_FragColor = base * sum;
}
)";

struct Spoilt {
    std::string_view rule;
    Stage stage;
    std::string_view find, replacement;
    int line;
};

constexpr Stage kV = Stage::Vertex;
constexpr Stage kF = Stage::Fragment;

constexpr Spoilt kSpoilt[] = {
    {"version", kV, "#version 100", "#version 300 es", 1},
    {"version", kF, "#version 100\n", "", 1},
    {"version", kV, "#version 100", "\n#version 100", 1},
    {"directive", kF, "#ifdef", "#line 12\n#ifdef", 2},
    {"directive", kV, "attribute vec3", "#define HALF 0.5\nattribute vec3", 2},
    {"layout", kV, "  vSun = uSun;", "\tvSun = uSun;", 10},
    {"layout", kV, "  vSun = uSun;", "  vSun = uSun; ", 10},
    {"layout", kV, "  vSun = uSun;", "  vSun = uSun; // \xc2\xb5", 10},
    {"layout", kV, "  vSun = uSun;\n", "  vSun = uSun;\r\n", 10},
    {"layout", kV, "  vSun = uSun;",
     "  vSun = uSun; // 3456789012345678901234567890123456789012345678901234567890123456789012345678901234567"
     "890123456789012345678901234567890",
     10},
    {"precision", kF,
     "#ifdef GL_FRAGMENT_PRECISION_HIGH\nprecision highp float;\n#else\nprecision mediump float;\n#endif\n",
     "", 2},
    {"precision", kF, "#ifdef", "varying float vEarly;\n#ifdef", 2},
    {"output", kV, "gl_Position", "gl_PointSize", 1},
    {"output", kF, "  gl_FragColor = base * sum;", "  discard;", 1},
    {"integer-literal", kF, "Surface(0.5)", "Surface(1)", 27},
    {"integer-literal", kV, "1.0);", "1);", 11},
    {"integer-literal", kF, "int i = 1", "float i = 1", 20},
    {"integer-literal", kF, "n.y;", "(n.y + 0x10);", 20},
    {"matrix-constructor", kV, "vSun = uSun;", "vSun = mat3(uModel) * uSun;", 10},
    {"matrix-constructor", kV, "vSun = uSun;", "mat4 m = uModel; vSun = mat3(m * uModel) * uSun;", 10},
    {"loop-bounds", kF, "i < kTerms", "i < sum", 20},
    {"loop-bounds", kF, "int i = 1", "int i = sum", 20},
    {"loop-bounds", kF, "++i)", "i *= 2)", 20},
    {"loop-bounds", kF, "for (int i = 1; i < kTerms; ++i)", "while (sum < 1.0)", 20},
    {"sampler-index", kF, "uTexture[1]", "uTexture[kTerms]", 28},
    {"sampler-index", kF, "uTexture[1]", "uTexture[1 - 1]", 28},
    {"extension-function", kF, "* sum;", "* dFdx(sum);", 32},
    {"extension-function", kF, "texture2D(uTexture[1], vUv)", "texture2DLodEXT(uTexture[1], vUv, 0.0)", 28},
    {"normalized-swizzle", kV, "vSun = uSun;", "vSun = normalize(uModel * vec4(uSun, 0.0)).xyz;", 10},
    {"reserved-name", kV, "vSun = uSun;", "vec3 a__b = uSun; vSun = a__b;", 10},
    {"reserved-name", kV, "vSun = uSun;", "vec3 gl_sun = uSun; vSun = gl_sun;", 10},
    {"reserved-name", kV, "vSun = uSun;", "vec3 half = uSun; vSun = half;", 10},
    {"declared-twice", kV, "uniform mat4 uModel;", "uniform mat4 uModel; uniform mat4 uModel;", 4},
    {"declared-twice", kF, "struct Surface", "struct Surface { float alpha; };\nstruct Surface", 14},
    {"declared-twice", kF, "void main", "vec3 skyLight(vec3 n, inout float x) { return n * x; }\nvoid main",
     25},
    {"unused", kV, "uniform mat4 uModel;", "uniform mat4 uModel;\nuniform vec4 uSpare;", 5},
    {"unused", kV, "attribute vec2 aUv;", "attribute vec2 aUv, aUv1;", 3},
    {"unused", kV, "  vUv = aUv;", "  vec2 vUv = aUv; vSun = vUv.xyx;", 6},
    {"unused", kF, "varying vec3 vSun;", "varying vec3 vSun; // vUv1\nvarying vec2 vUv1;", 13},
    {"unused", kF, "  float alpha; // 0-1", "  float alpha;\n  float spare;", 15},
    {"unused", kF, "struct Surface", "struct Spare { float x; };\nstruct Surface", 13},
    {"unused", kF, "vec3 skyLight", "float spare() { return spare(); }\nvec3 skyLight", 18},
    {"unused", kF, "vec3 skyLight",
     "float spare() { return 1.0; }\nfloat caller() { return spare(); }\nvec3 skyLight", 18},
    {"unused", kF, "(vec3 n, inout", "(vec3 n, float spare, inout", 18},
    {"unused", kF, "float sum = 0.0, x;", "float sum = 0.0, x, y; y = 1.0;", 26},
    {"unused", kF, "  return light;",
     "  light.xy = light.yx; vec3 spare = light; spare.x += 1.0; return light;", 22},
    {"unused", kF, "const int", "const float kSpare = 1.0;\nconst int", 16},
    {"varying-declared", kF, "varying vec3 vSun;", "varying vec3 vSun;\nvarying vec3 vMoon;", 13},
    {"varying-type", kF, "varying vec2 vUv;", "varying vec3 vUv;", 11},
    {"varying-read", kV, "varying vec2 vUv;", "varying vec2 vUv;\nvarying vec2 vUv1;", 7},
    {"uniform-type", kF, "uniform mediump vec3 uSun;", "uniform mediump vec4 uSun;", 8},
    {"uniform-type", kF, "uniform mediump vec3 uSun;", "uniform mediump vec3 uSun[2];", 8},
    {"uniform-precision", kF, "uniform mediump vec3 uSun;", "uniform vec3 uSun;", 8},
    {"uniform-precision", kV, "uniform mediump vec3 uSun;", "uniform highp vec3 uSun;", 8},
};

ComposedStage stageOf(std::string_view text) { return {std::string(text), {}}; }

Composed goodProgram() { return {stageOf(kVertex), stageOf(kFragment), {}}; }

Composed spoil(const Spoilt& row) {
    Composed program = goodProgram();
    std::string& text = (row.stage == kV ? program.vertex : program.fragment).text;
    const std::size_t at = text.find(row.find);
    EXPECT_NE(at, std::string::npos) << row.find;
    text.replace(at, row.find.size(), row.replacement);
    return program;
}

std::string listOf(const std::vector<LintFinding>& findings) {
    std::string list;
    for (const LintFinding& finding : findings)
        list += toString(finding) + '\n';
    return list;
}

TEST(Lint, FindsNothingInAGoodProgram) { EXPECT_EQ(listOf(lintProgram(goodProgram())), ""); }

TEST(Lint, FindsWhatIsSpoilt) {
    for (const Spoilt& row : kSpoilt) {
        const std::vector<LintFinding> findings = lintProgram(spoil(row));
        bool found = false;
        for (const LintFinding& finding : findings)
            found = found || (finding.rule == row.rule && finding.line == row.line);
        EXPECT_TRUE(found) << row.rule << " should report line " << row.line << " after '" << row.replacement
                           << "', found:\n"
                           << listOf(findings);
    }
}

TEST(Lint, EachRuleHasATest) {
    std::set<std::string_view> tested;
    for (const Spoilt& row : kSpoilt)
        tested.insert(row.rule);
    for (const LintRule& rule : lintRules()) {
        EXPECT_EQ(tested.count(rule.id), 1u) << rule.id;
        EXPECT_FALSE(rule.meaning.empty());
    }
    EXPECT_EQ(tested.size(), lintRules().size());
}

TEST(Lint, NamesTheSnippet) {
    ComposedStage stage = stageOf("#version 100\nvoid main() {\n  gl_Position = vec4(1);\n}\n");
    stage.lines = {{{}, 0}, {{}, 0}, {"vertex/transform/position", 6}, {{}, 0}};
    const std::vector<LintFinding> findings = lint(stage, Stage::Vertex);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(toString(findings[0]),
              "generator/glsl/vertex/transform/position.glsl:6: the integer '1' stands where a "
              "float is meant [integer-literal]");
}

TEST(Lint, SurvivesAnyText) {
    for (const std::string_view text : {"",
                                        "\n",
                                        "{",
                                        "}",
                                        "(",
                                        "struct",
                                        "struct {",
                                        "vec3",
                                        "vec3 f(",
                                        "#",
                                        "/*",
                                        "for (",
                                        "float x[",
                                        "uniform",
                                        "1.",
                                        "precision",
                                        "mat3(",
                                        "normalize",
                                        "void main() { float",
                                        "in in in",
                                        ";;",
                                        "e 1e+"})
        EXPECT_FALSE(lintProgram({stageOf(text), stageOf(text), {}}).empty()) << text;
    for (std::size_t size = 0; size < kFragment.size(); ++size)
        lint(stageOf(kFragment.substr(0, size)), Stage::Fragment);
}

} // namespace
} // namespace franken
