// SPDX-License-Identifier: MIT
#include "glsl_syntax.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace franken {
namespace {

constexpr std::array<std::string_view, 18> kTypes = {
    "void",  "bool",  "int",   "float", "vec2", "vec3", "vec4", "ivec2",     "ivec3",
    "ivec4", "bvec2", "bvec3", "bvec4", "mat2", "mat3", "mat4", "sampler2D", "samplerCube",
};
constexpr std::array<std::string_view, 12> kLongSymbols = {
    "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "++", "--"};

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool isWordChar(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Tokenizer {
public:
    Tokenizer(std::string_view text, Syntax& syntax) : m_text(text), m_syntax(syntax) {}

    void run() {
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (c == '\n')
                ++m_line, ++m_at;
            else if (std::isspace(static_cast<unsigned char>(c)))
                ++m_at;
            else if (rest().starts_with("//"))
                m_at = endOfLine();
            else if (rest().starts_with("/*"))
                skipComment();
            else if (c == '#')
                m_syntax.directives.push_back({take(endOfLine() - m_at), m_line});
            else
                addToken(c);
        }
    }

private:
    std::string_view rest() const { return m_text.substr(m_at); }
    std::size_t endOfLine() const { return std::min(m_text.find('\n', m_at), m_text.size()); }

    std::string_view take(std::size_t size) {
        const std::string_view taken = m_text.substr(m_at, size);
        m_at += taken.size();
        return taken;
    }

    void skipComment() {
        const std::size_t end = std::min(m_text.find("*/", m_at + 2), m_text.size());
        m_line += static_cast<int>(std::count(m_text.begin() + m_at, m_text.begin() + end, '\n'));
        m_at = std::min(end + 2, m_text.size());
    }

    void addToken(char c) {
        const int line = m_line;
        if (isDigit(c) || (c == '.' && rest().size() > 1 && isDigit(rest()[1]))) {
            const std::string_view number = take(numberSize());
            const bool integer = number.find_first_of(".eE") == std::string_view::npos;
            m_syntax.tokens.push_back({integer ? Token::Kind::Integer : Token::Kind::Float, number, line});
        } else if (isWordChar(c)) {
            const auto end = std::find_if_not(m_text.begin() + m_at, m_text.end(), isWordChar);
            const auto size = static_cast<std::size_t>(end - m_text.begin()) - m_at;
            m_syntax.tokens.push_back({Token::Kind::Word, take(size), line});
        } else {
            const bool isLong = std::find(kLongSymbols.begin(), kLongSymbols.end(), rest().substr(0, 2)) !=
                                kLongSymbols.end();
            m_syntax.tokens.push_back({Token::Kind::Symbol, take(isLong ? 2 : 1), line});
        }
    }

    std::size_t numberSize() const {
        std::size_t size = 1;
        for (; m_at + size < m_text.size(); ++size) {
            const char c = m_text[m_at + size];
            const char before = m_text[m_at + size - 1];
            const bool sign = (c == '-' || c == '+') && (before == 'e' || before == 'E');
            if (!isWordChar(c) && c != '.' && !sign)
                break;
        }
        return size;
    }

    std::string_view m_text;
    Syntax& m_syntax;
    std::size_t m_at = 0;
    int m_line = 1;
};

bool isQualifier(std::string_view word) {
    return word == "uniform" || word == "varying" || word == "attribute" || word == "const" || word == "in" ||
           word == "inout" || word == "out";
}

bool isPrecision(std::string_view word) { return word == "highp" || word == "mediump" || word == "lowp"; }

class Parser {
public:
    explicit Parser(Syntax& syntax) : m_syntax(syntax) {}

    void run() {
        while (m_at < m_syntax.tokens.size()) {
            if (now() == "struct")
                parseStruct();
            else if (now() == "precision" || !startsVariable())
                skipPast(";");
            else
                parseGlobal();
        }
    }

private:
    std::string_view now(std::size_t ahead = 0) const { return m_syntax.at(m_at + ahead); }

    void skipPast(std::string_view symbol) {
        while (m_at < m_syntax.tokens.size() && now() != symbol)
            ++m_at;
        ++m_at;
    }

    // A constructor, vec3(...), is the one other place where a type stands.
    bool startsVariable() const {
        return (isQualifier(now()) || isPrecision(now()) || m_syntax.isType(now())) && now(1) != "(";
    }

    // "uniform mediump vec3 uName" up to and with the name.
    Variable takeVariable() {
        Variable variable{};
        if (isQualifier(now())) {
            variable.qualifier = now();
            ++m_at;
        }
        if (isPrecision(now())) {
            variable.precision = now();
            ++m_at;
        }
        variable.type = now();
        takeName(variable, m_at + 1);
        return variable;
    }

    void takeName(Variable& variable, std::size_t token) {
        variable.name = m_syntax.at(token);
        variable.token = token;
        variable.array = m_syntax.at(token + 1) == "[";
        m_at = token + 1;
    }

    // The declarators of one statement, up to and with its ';'.
    void takeDeclarators(std::vector<Variable>& variables) {
        Variable variable = takeVariable();
        variables.push_back(variable);
        while (m_at < m_syntax.tokens.size() && now() != ";") {
            if (now() == ",") {
                takeName(variable, m_at + 1);
                variables.push_back(variable);
            } else {
                m_at = isOpening() ? m_syntax.closing(m_at) + 1 : m_at + 1;
            }
        }
        ++m_at;
    }

    bool isOpening() const { return now() == "(" || now() == "[" || now() == "{"; }

    void parseStruct() {
        Struct record{now(1), m_at + 1, {}};
        const std::size_t end = m_syntax.closing(m_at + 2);
        for (m_at += 3; m_at < end;)
            takeDeclarators(record.members);
        m_syntax.structs.push_back(std::move(record));
        skipPast(";");
    }

    void parseGlobal() {
        const std::size_t first = m_at;
        const Variable variable = takeVariable();
        if (now() == "(")
            return parseFunction(first, variable);
        m_at = first;
        takeDeclarators(m_syntax.globals);
    }

    void parseFunction(std::size_t first, const Variable& head) {
        const std::size_t close = m_syntax.closing(m_at);
        Function function{head.name, head.token, first, close + 1, close + 1, {}, {}};
        for (++m_at; m_at < close;)
            if (startsVariable() && now() != "void")
                function.parameters.push_back(takeVariable());
            else
                ++m_at;
        m_at = close + 1;
        if (now() != "{")
            return skipPast(";");
        function.end = m_syntax.closing(m_at) + 1;
        while (m_at < function.end)
            if (startsVariable())
                takeDeclarators(function.locals);
            else
                ++m_at;
        m_at = function.end;
        m_syntax.functions.push_back(std::move(function));
    }

    Syntax& m_syntax;
    std::size_t m_at = 0;
};

} // namespace

bool Syntax::mentions(std::string_view word) const {
    return std::any_of(tokens.begin(), tokens.end(), [word](const Token& token) { return token.is(word); });
}

bool Syntax::isType(std::string_view word) const {
    return std::find(kTypes.begin(), kTypes.end(), word) != kTypes.end() ||
           std::any_of(structs.begin(), structs.end(), [&](const Struct& s) { return s.name == word; });
}

std::size_t Syntax::closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t token = open; token < tokens.size(); ++token) {
        const std::string_view text = tokens[token].text;
        if (text == "(" || text == "[" || text == "{")
            ++depth;
        else if ((text == ")" || text == "]" || text == "}") && --depth <= 0)
            return token;
    }
    return tokens.empty() ? 0 : tokens.size() - 1;
}

Syntax parseGlsl(std::string_view text) {
    Syntax syntax;
    Tokenizer(text, syntax).run();
    Parser(syntax).run();
    return syntax;
}

} // namespace franken
