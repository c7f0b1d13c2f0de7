// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace franken {

struct Token {
    enum class Kind { Word, Integer, Float, Symbol } kind;
    std::string_view text;
    int line; ///< From 1.

    bool is(std::string_view what) const { return text == what; }
};

/// "#version 100", with its line.
struct Directive {
    std::string_view text;
    int line;
};

/// A global variable, a parameter, a local or a member of a struct.
struct Variable {
    std::string_view qualifier; ///< "uniform", "varying", "attribute", "const", "in", "inout", "out" or "".
    std::string_view precision; ///< "highp", "mediump", "lowp" or "".
    std::string_view type, name;
    std::size_t token; ///< Index of the name's token.
    bool array = false;
};

struct Struct {
    std::string_view name;
    std::size_t token;
    std::vector<Variable> members;
};

/// A function with a body: tokens [first, end), the body's from `body` on.
struct Function {
    std::string_view name;
    std::size_t token, first, body, end;
    std::vector<Variable> parameters, locals;
};

/// As much of a shader's syntax as the lint asks for. Both branches of an #ifdef are read.
struct Syntax {
    std::vector<Directive> directives;
    std::vector<Token> tokens;
    std::vector<Variable> globals;
    std::vector<Struct> structs;
    std::vector<Function> functions;

    bool isType(std::string_view word) const;
    /// Whether any token is that word.
    bool mentions(std::string_view word) const;
    /// The token that closes the bracket at `open`; the last token where none does.
    std::size_t closing(std::size_t open) const;
    /// The token's line; past the end, the last token's.
    int lineOf(std::size_t token) const {
        return tokens.empty() ? 1 : tokens[std::min(token, tokens.size() - 1)].line;
    }
    /// The token's text, "" past the end.
    std::string_view at(std::size_t token) const {
        return token < tokens.size() ? tokens[token].text : std::string_view();
    }
};

/// Takes GLSL ES 1.00 apart; the text must outlive the result.
Syntax parseGlsl(std::string_view text);

} // namespace franken
