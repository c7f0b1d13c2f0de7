// SPDX-License-Identifier: MIT
#include "lint_rules.h"

namespace franken {
namespace {

const Variable* findGlobal(const Syntax& syntax, std::string_view qualifier, std::string_view name) {
    for (const Variable& global : syntax.globals)
        if (global.qualifier == qualifier && global.name == name)
            return &global;
    return nullptr;
}

// Asks `ask` about every global of that kind in `ours` and its namesake in `theirs`, which may be missing.
template<typename Ask>
std::vector<Broken> compare(const Syntax& ours, const Syntax& theirs, std::string_view qualifier, Ask ask) {
    std::vector<Broken> broken;
    for (const Variable& variable : ours.globals)
        if (variable.qualifier == qualifier)
            if (std::string message = ask(variable, findGlobal(theirs, qualifier, variable.name));
                !message.empty())
                broken.push_back({ours.lineOf(variable.token), quoted(variable.name) + " " + message});
    return broken;
}

std::string typeDiffers(const Variable& ours, const Variable* theirs) {
    const bool same = !theirs || (ours.type == theirs->type && ours.array == theirs->array);
    return same ? "" : "has another type in the vertex shader";
}

std::vector<Broken> varyingDeclared(const Syntax& vertex, const Syntax& fragment) {
    return compare(fragment, vertex, "varying", [](const Variable&, const Variable* theirs) -> std::string {
        return theirs ? "" : "is not declared by the vertex shader";
    });
}

std::vector<Broken> varyingRead(const Syntax& vertex, const Syntax& fragment) {
    return compare(vertex, fragment, "varying", [](const Variable&, const Variable* theirs) -> std::string {
        return theirs ? "" : "is not read by the fragment shader";
    });
}

std::vector<Broken> varyingType(const Syntax& vertex, const Syntax& fragment) {
    return compare(fragment, vertex, "varying", typeDiffers);
}

std::vector<Broken> uniformType(const Syntax& vertex, const Syntax& fragment) {
    return compare(fragment, vertex, "uniform", typeDiffers);
}

std::vector<Broken> uniformPrecision(const Syntax& vertex, const Syntax& fragment) {
    return compare(fragment, vertex, "uniform",
                   [](const Variable& ours, const Variable* theirs) -> std::string {
                       const bool sampler = ours.type.starts_with("sampler");
                       const bool same = !theirs || sampler ||
                                         (ours.precision == "mediump" && theirs->precision == "mediump");
                       return same ? "" : "is in both stages and must be 'mediump' in both";
                   });
}

constexpr LinkRuleCheck kLinkRules[] = {
    {{"varying-declared", "The vertex shader declares the fragment shader's varyings."},
     Stage::Fragment,
     varyingDeclared},
    {{"varying-type", "Both stages give a varying the same type."}, Stage::Fragment, varyingType},
    {{kVaryingRead, "The fragment shader declares the vertex shader's varyings."},
     Stage::Vertex,
     varyingRead},
    {{"uniform-type", "Both stages give a uniform the same type."}, Stage::Fragment, uniformType},
    {{"uniform-precision", "A uniform of both stages is mediump in both: where fragments have no highp, "
                           "unequal ones do not link."},
     Stage::Fragment,
     uniformPrecision},
};

} // namespace

std::span<const LinkRuleCheck> linkRules() { return kLinkRules; }

} // namespace franken
