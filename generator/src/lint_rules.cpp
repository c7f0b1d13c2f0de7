// SPDX-License-Identifier: MIT
#include "lint_rules.h"

#include <algorithm>
#include <array>

namespace franken {
namespace {

constexpr std::size_t kColumns = 120;

constexpr std::array<std::string_view, 13> kBuiltins = {"gl_Position",
                                                        "gl_PointSize",
                                                        "gl_FragColor",
                                                        "gl_FragCoord",
                                                        "gl_FrontFacing",
                                                        "gl_PointCoord",
                                                        "gl_FragData",
                                                        "gl_DepthRange",
                                                        "gl_MaxDrawBuffers",
                                                        "gl_MaxVaryingVectors",
                                                        "gl_MaxVertexAttribs",
                                                        "gl_MaxTextureImageUnits",
                                                        "gl_MaxVertexUniformVectors"};

// GLSL ES 1.00, 3.6: kept for later versions of the language.
constexpr std::array<std::string_view, 44> kReserved = {
    "asm",    "class",    "union",     "enum",   "typedef",  "template", "this",      "packed",
    "goto",   "switch",   "default",   "inline", "noinline", "volatile", "public",    "static",
    "extern", "external", "interface", "flat",   "long",     "short",    "double",    "half",
    "fixed",  "unsigned", "superp",    "input",  "output",   "hvec2",    "hvec3",     "hvec4",
    "dvec2",  "dvec3",    "dvec4",     "fvec2",  "fvec3",    "fvec4",    "sampler1D", "sampler3D",
    "sizeof", "cast",     "namespace", "using"};

// Derivatives and explicit levels of detail need extensions that Mesa does not offer to GLES2 on these GPUs.
constexpr std::array<std::string_view, 14> kExtensionFunctions = {"dFdx",
                                                                  "dFdy",
                                                                  "fwidth",
                                                                  "texture2DLod",
                                                                  "texture2DProjLod",
                                                                  "textureCubeLod",
                                                                  "texture2DLodEXT",
                                                                  "texture2DProjLodEXT",
                                                                  "textureCubeLodEXT",
                                                                  "texture2DGradEXT",
                                                                  "texture2DProjGradEXT",
                                                                  "textureCubeGradEXT",
                                                                  "texture2DGradARB",
                                                                  "texture2DLodARB"};

template<std::size_t Size>
bool isAnyOf(const std::array<std::string_view, Size>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

template<typename Visit>
void forEachLine(std::string_view text, Visit visit) {
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        visit(text.substr(0, end), number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::vector<Broken> version(const ShaderText& shader) {
    if (shader.text.starts_with("#version 100\n"))
        return {};
    return {{1, "the text must begin with '#version 100'"}};
}

std::vector<Broken> directive(const ShaderText& shader) {
    constexpr std::array<std::string_view, 8> kAllowed = {"#version", "#extension", "#if",   "#ifdef",
                                                          "#ifndef",  "#elif",      "#else", "#endif"};
    std::vector<Broken> broken;
    for (const Directive& found : shader.syntax.directives) {
        const std::string_view word = found.text.substr(0, found.text.find_first_of(" \t"));
        if (!isAnyOf(kAllowed, word))
            broken.push_back({found.line, quoted(word) + " is not allowed"});
    }
    return broken;
}

std::vector<Broken> layout(const ShaderText& shader) {
    std::vector<Broken> broken;
    forEachLine(shader.text, [&](std::string_view line, int number) {
        // A program's name is one word, to be pasted.
        if (line.size() > kColumns && !line.starts_with("// FrankenShader "))
            broken.push_back({number, "the line has " + std::to_string(line.size()) + " columns"});
        if (line.ends_with(' '))
            broken.push_back({number, "the line ends in a space"});
        const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
        if (!std::all_of(line.begin(), line.end(), printable))
            broken.push_back({number, "the line holds a tab or a character beyond ASCII"});
    });
    if (!shader.text.ends_with('\n'))
        broken.push_back({1, "the last line does not end"});
    return broken;
}

std::vector<Broken> precision(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    if (shader.stage == Stage::Vertex)
        return {};
    for (std::size_t token = 0; token < syntax.tokens.size(); ++token) {
        if (syntax.at(token) == "precision" && syntax.at(token + 2) == "float")
            return {};
        if (syntax.isType(syntax.at(token)))
            return {{syntax.lineOf(token), "no 'precision ... float;' stands before this declaration"}};
    }
    return {{1, "there is no 'precision ... float;'"}};
}

std::vector<Broken> output(const ShaderText& shader) {
    const std::string_view name = shader.stage == Stage::Vertex ? "gl_Position" : "gl_FragColor";
    if (shader.syntax.mentions(name))
        return {};
    return {{1, quoted(name) + " is never written"}};
}

// Tokens from which `end` on integers stand for floats again: "int i = 0;", "for (int ...)", "[4]".
std::size_t endOfIntegers(const Syntax& syntax, std::size_t token) {
    if (syntax.at(token) == "[" || (syntax.at(token) == "for" && syntax.at(token + 2) == "int"))
        return syntax.closing(syntax.at(token) == "[" ? token : token + 1);
    if (syntax.at(token) == "int" && syntax.at(token + 1) != "(")
        while (token < syntax.tokens.size() && syntax.at(token) != ";")
            ++token;
    return token;
}

std::vector<Broken> integerLiteral(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    std::vector<Broken> broken;
    for (std::size_t token = 0; token < syntax.tokens.size(); ++token) {
        token = endOfIntegers(syntax, token);
        if (token < syntax.tokens.size() && syntax.tokens[token].kind == Token::Kind::Integer)
            broken.push_back({syntax.lineOf(token),
                              "the integer " + quoted(syntax.at(token)) + " stands where a float is meant"});
    }
    return broken;
}

bool isMatrix(std::string_view type) { return type == "mat2" || type == "mat3" || type == "mat4"; }

bool namesMatrix(const Syntax& syntax, std::string_view name) {
    const auto matrix = [name](const Variable& v) { return v.name == name && isMatrix(v.type); };
    return std::any_of(syntax.globals.begin(), syntax.globals.end(), matrix) ||
           std::any_of(syntax.functions.begin(), syntax.functions.end(), [&](const Function& function) {
               return std::any_of(function.parameters.begin(), function.parameters.end(), matrix) ||
                      std::any_of(function.locals.begin(), function.locals.end(), matrix);
           });
}

// GLSL ES 1.00, 5.4.2: a matrix cannot be made from a matrix.
std::vector<Broken> matrixConstructor(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    std::vector<Broken> broken;
    for (std::size_t token = 0; token < syntax.tokens.size(); ++token) {
        if (!isMatrix(syntax.at(token)) || syntax.at(token + 1) != "(")
            continue;
        const std::size_t close = syntax.closing(token + 1);
        bool matrix = false, columns = false;
        for (std::size_t inside = token + 2; inside < close; ++inside) {
            if (syntax.at(inside) == "(" || syntax.at(inside) == "[")
                inside = syntax.closing(inside);
            columns = columns || syntax.at(inside) == ",";
            matrix = matrix || (namesMatrix(syntax, syntax.at(inside)) && syntax.at(inside + 1) != "[");
        }
        if (matrix && !columns)
            broken.push_back(
                {syntax.lineOf(token), quoted(syntax.at(token)) + " is made from another matrix"});
    }
    return broken;
}

bool isConstant(const Syntax& syntax, std::size_t token) {
    if (token >= syntax.tokens.size())
        return false;
    if (syntax.tokens[token].kind == Token::Kind::Integer || syntax.tokens[token].kind == Token::Kind::Float)
        return true;
    const auto named = [&](const Variable& v) {
        return v.name == syntax.at(token) && v.qualifier == "const";
    };
    return std::any_of(syntax.globals.begin(), syntax.globals.end(), named);
}

// "for (int i = 0; i < 4; ++i)", the form of GLSL ES 1.00, appendix A, 4.
bool isConstantLoop(const Syntax& syntax, std::size_t open) {
    const std::string_view index = syntax.at(open + 2);
    const std::string_view relation = syntax.at(open + 7);
    const bool compares = relation == "<" || relation == "<=" || relation == ">" || relation == ">=" ||
                          relation == "!=" || relation == "==";
    const bool starts = (syntax.at(open + 1) == "int" || syntax.at(open + 1) == "float") &&
                        syntax.at(open + 3) == "=" && isConstant(syntax, open + 4) &&
                        syntax.at(open + 5) == ";";
    const bool bounded = syntax.at(open + 6) == index && compares && isConstant(syntax, open + 8) &&
                         syntax.at(open + 9) == ";";
    const std::string_view first = syntax.at(open + 10), second = syntax.at(open + 11);
    const bool counts = ((first == "++" || first == "--") && second == index) ||
                        (first == index && (second == "++" || second == "--"));
    const bool steps = first == index && (second == "+=" || second == "-=") && isConstant(syntax, open + 12);
    return starts && bounded && (counts || steps) && syntax.closing(open) == open + (steps ? 13 : 12);
}

std::vector<Broken> loopBounds(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    std::vector<Broken> broken;
    for (std::size_t token = 0; token < syntax.tokens.size(); ++token) {
        const std::string_view word = syntax.at(token);
        if (word == "while" || word == "do" || (word == "for" && !isConstantLoop(syntax, token + 1)))
            broken.push_back({syntax.lineOf(token), quoted(word) + " without constant bounds"});
    }
    return broken;
}

bool indexedByNumber(const Syntax& syntax, std::size_t open) {
    return open + 1 < syntax.tokens.size() && syntax.tokens[open + 1].kind == Token::Kind::Integer &&
           syntax.at(open + 2) == "]";
}

std::vector<Broken> samplerIndex(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    std::vector<Broken> broken;
    for (const Variable& global : syntax.globals)
        for (std::size_t token = 0; global.type.starts_with("sampler") && token < syntax.tokens.size();
             ++token)
            if (syntax.at(token) == global.name && syntax.at(token + 1) == "[" &&
                !indexedByNumber(syntax, token + 1))
                broken.push_back({syntax.lineOf(token),
                                  quoted(global.name) + " is indexed by something else than a number"});
    return broken;
}

std::vector<Broken> extensionFunction(const ShaderText& shader) {
    std::vector<Broken> broken;
    for (const Token& token : shader.syntax.tokens)
        if (isAnyOf(kExtensionFunctions, token.text))
            broken.push_back({token.line, quoted(token.text) + " does not exist on these GPUs"});
    return broken;
}

// With a mat4 product inside, the fourth component would be part of the length.
std::vector<Broken> normalizedSwizzle(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    std::vector<Broken> broken;
    for (std::size_t token = 0; token < syntax.tokens.size(); ++token)
        if (syntax.at(token) == "normalize" && syntax.at(syntax.closing(token + 1) + 1) == ".")
            broken.push_back({syntax.lineOf(token), "components are taken after 'normalize', not before"});
    return broken;
}

std::vector<Broken> reservedName(const ShaderText& shader) {
    std::vector<Broken> broken;
    for (const Token& token : shader.syntax.tokens) {
        const bool builtin = token.text.starts_with("gl_") && !isAnyOf(kBuiltins, token.text);
        if (token.text.find("__") != std::string_view::npos || builtin || isAnyOf(kReserved, token.text))
            broken.push_back({token.line, quoted(token.text) + " is reserved"});
    }
    return broken;
}

template<typename Named, typename Same>
void findRepeated(const Syntax& syntax, const std::vector<Named>& all, Same same,
                  std::vector<Broken>& broken) {
    for (auto one = all.begin(); one != all.end(); ++one)
        if (std::any_of(all.begin(), one, [&](const Named& earlier) { return same(earlier, *one); }))
            broken.push_back({syntax.lineOf(one->token), quoted(one->name) + " is declared twice"});
}

// Functions of one name may differ in the types of their parameters.
bool sameHead(const Function& a, const Function& b) {
    return a.name == b.name &&
           std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(), b.parameters.end(),
                      [](const Variable& x, const Variable& y) { return x.type == y.type; });
}

std::vector<Broken> declaredTwice(const ShaderText& shader) {
    const Syntax& syntax = shader.syntax;
    const auto sameName = [](const auto& a, const auto& b) { return a.name == b.name; };
    std::vector<Broken> broken;
    findRepeated(syntax, syntax.globals, sameName, broken);
    findRepeated(syntax, syntax.structs, sameName, broken);
    findRepeated(syntax, syntax.functions, sameHead, broken);
    return broken;
}

constexpr StageRuleCheck kStageRules[] = {
    {{"version", "'#version 100' is the first line."}, version},
    {{"directive", "No directives but #version, #extension and #if...: no #line, no #define."}, directive},
    {{"layout", "At most 120 columns, plain ASCII, no tabs, no trailing spaces."}, layout},
    {{"precision", "A fragment shader sets the precision of floats before its first declaration."},
     precision},
    {{"output", "gl_Position, or gl_FragColor, is written."}, output},
    {{"integer-literal", "Integers stand only in indices, array sizes and integer variables."},
     integerLiteral},
    {{"matrix-constructor", "No matrix is made from another matrix."}, matrixConstructor},
    {{"loop-bounds", "Loops are 'for' loops from one constant to another."}, loopBounds},
    {{"sampler-index", "Arrays of samplers are indexed by numbers."}, samplerIndex},
    {{"extension-function", "No derivatives and no explicit level of detail."}, extensionFunction},
    {{"normalized-swizzle", "Nothing is swizzled after normalize()."}, normalizedSwizzle},
    {{"reserved-name", "No '__', no gl_ of one's own, no word reserved for later."}, reservedName},
    {{"declared-twice", "Global variables, structs and functions are declared once."}, declaredTwice},
    {{"unused", "Whatever is declared is used."}, findUnused},
};

} // namespace

std::string quoted(std::string_view text) { return std::string(1, '\'').append(text).append(1, '\''); }

std::span<const StageRuleCheck> stageRules() { return kStageRules; }

} // namespace franken
