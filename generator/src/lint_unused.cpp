// SPDX-License-Identifier: MIT
#include "lint_rules.h"

#include <algorithm>

namespace franken {
namespace {

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool declares(const Function& function, std::string_view name) {
    const auto named = [name](const Variable& variable) { return variable.name == name; };
    return std::any_of(function.parameters.begin(), function.parameters.end(), named) ||
           std::any_of(function.locals.begin(), function.locals.end(), named);
}

class Usage {
public:
    explicit Usage(const ShaderText& shader) : m_shader(shader), m_syntax(shader.syntax) { visit("main"); }

    bool called(std::string_view function) const { return contains(m_called, function); }

    bool global(const Variable& variable) const {
        const bool writingIsUse = m_shader.stage == Stage::Vertex && variable.qualifier == "varying";
        return anyLive([&](const Function& function) {
            return !declares(function, variable.name) &&
                   mentions(function.first, function.end, variable, writingIsUse);
        });
    }

    bool type(std::string_view name) const {
        return anyLive([&](const Function& function) {
            return anyToken(function.first, function.end,
                            [&](std::size_t t) { return m_syntax.at(t) == name; });
        });
    }

    bool member(std::string_view name) const {
        return anyLive([&](const Function& function) {
            return anyToken(function.body, function.end,
                            [&](std::size_t t) { return m_syntax.at(t) == name && isField(t); });
        });
    }

    bool local(const Function& function, const Variable& variable) const {
        const bool out = variable.qualifier == "out" || variable.qualifier == "inout";
        return mentions(std::max(function.body, variable.token + 1), function.end, variable, out);
    }

private:
    void visit(std::string_view name) {
        if (contains(m_called, name))
            return;
        m_called.push_back(name);
        for (const Function& function : m_syntax.functions)
            if (function.name == name)
                for (std::size_t token = function.body; token < function.end; ++token)
                    if (m_syntax.at(token + 1) == "(")
                        visit(m_syntax.at(token));
    }

    template<typename Predicate>
    bool anyLive(Predicate predicate) const {
        return std::any_of(m_syntax.functions.begin(), m_syntax.functions.end(),
                           [&](const Function& f) { return called(f.name) && predicate(f); });
    }

    template<typename Predicate>
    static bool anyToken(std::size_t first, std::size_t end, Predicate predicate) {
        for (std::size_t token = first; token < end; ++token)
            if (predicate(token))
                return true;
        return false;
    }

    bool isField(std::size_t token) const { return token > 0 && m_syntax.at(token - 1) == "."; }

    bool mentions(std::size_t first, std::size_t end, const Variable& variable, bool writingIsUse) const {
        return anyToken(first, end, [&](std::size_t token) {
            return token != variable.token && m_syntax.at(token) == variable.name && !isField(token) &&
                   (writingIsUse || !onlyWrites(token));
        });
    }

    // "color.rgb += ...;" gives color a value that somebody else must read.
    bool onlyWrites(std::size_t token) const {
        const std::string_view before = m_syntax.at(token - 1);
        const bool startsStatement =
            before == ";" || before == "{" || before == "}" || before == ")" || before == "else";
        const std::size_t after = m_syntax.at(token + 1) == "." ? token + 3 : token + 1;
        const std::string_view symbol = m_syntax.at(after);
        return startsStatement &&
               (symbol == "=" || symbol == "+=" || symbol == "-=" || symbol == "*=" || symbol == "/=");
    }

    const ShaderText& m_shader;
    const Syntax& m_syntax;
    std::vector<std::string_view> m_called;
};

} // namespace

std::vector<Broken> findUnused(const ShaderText& shader) {
    const Usage usage(shader);
    const Syntax& syntax = shader.syntax;
    std::vector<Broken> unused;
    const auto check = [&](bool used, std::string_view what, std::string_view name, std::size_t token) {
        if (!used)
            unused.push_back(
                {syntax.lineOf(token), "the " + std::string(what) + " " + quoted(name) + " is not used"});
    };
    for (const Variable& global : syntax.globals)
        check(usage.global(global), global.qualifier.empty() ? "global" : global.qualifier, global.name,
              global.token);
    for (const Struct& record : syntax.structs) {
        check(usage.type(record.name), "struct", record.name, record.token);
        for (const Variable& member : record.members)
            check(usage.member(member.name), "member", member.name, member.token);
    }
    for (const Function& function : syntax.functions) {
        check(usage.called(function.name), "function", function.name, function.token);
        for (const Variable& parameter : function.parameters)
            check(usage.local(function, parameter), "parameter", parameter.name, parameter.token);
        for (const Variable& local : function.locals)
            check(usage.local(function, local), "variable", local.name, local.token);
    }
    return unused;
}

} // namespace franken
