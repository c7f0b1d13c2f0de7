// SPDX-License-Identifier: MIT
#include "effect_text.h"
#include "franken/generator/lint.h"
#include "glsl_syntax.h"
#include "library.h"

#include <algorithm>

namespace franken {
namespace {

LineOrigin originIn(const Effect::Text& text, int line) { return {text.file, line, true}; }

void declare(Part& part, const Effect::Text& text, const Effect::Text::Hook& hook) {
    const bool vertex = hook.hook->trait == kVertexHook;
    const Syntax syntax = parseGlsl(hook.text);
    int value = 0;
    for (const Effect::Text::Declaration& declaration : text.declarations) {
        const int ownValue = declaration.varying ? 0 : value++;
        if (!syntax.mentions(declaration.name))
            continue;
        const Group group = declaration.varying ? Group::Varyings : Group::UserUniforms;
        Part::Section& section = part.declarations[static_cast<std::size_t>(group)];
        section.text += declaration.text;
        section.lines.push_back(originIn(text, declaration.line));
        if (!declaration.varying)
            part.interface.uniforms.push_back(
                {declaration.name, Type::Vec4, 1, Block::User, vertex, !vertex, ownValue});
        else if (vertex)
            part.interface.varyings.push_back({declaration.name, declaration.type});
    }
}

// Lit by a sun, unlit, and lit by the sky alone: all hooks, and all that they read.
std::vector<Permutation> samples(const EffectChoice& effect) {
    std::vector<Permutation> all(3);
    all[0].suns = 1;
    all[1].shading = Shading::Unlit;
    all[2].ambient = Ambient::Sky;
    for (Permutation& sample : all) {
        sample.effect = effect;
        const Result<Canonical> canonical = canonicalise(sample);
        sample = canonical ? canonical->permutation : Permutation();
    }
    return all;
}

} // namespace

Part effectPart(Part part, const Effect& effect, std::string_view snippet) {
    const Effect::Text& text = effect.text();
    for (const Effect::Text::Hook& hook : text.hooks) {
        if (hook.hook->snippet != snippet)
            continue;
        declare(part, text, hook);
        part.functions.text += hook.text;
        const auto lines = std::count(hook.text.begin(), hook.text.end(), '\n');
        for (int line = 0; line < lines; ++line)
            part.functions.lines.push_back(originIn(text, hook.line + line));
        part.main.text.replace(part.main.text.find(kCall), kCall.size(), hook.call);
        return part;
    }
    return {};
}

Result<void> checkEffectText(const SnippetSet& snippets, const EffectChoice& effect) {
    for (const Permutation& sample : samples(effect))
        for (const LintFinding& finding : lintProgram(compose(sample, snippets)))
            if (finding.origin.effect)
                return Error{"effect.glsl", toString(finding.origin),
                             finding.message + " [" + std::string(finding.rule) + "]",
                             "write strict GLSL ES 1.00: see lint.h for the rules"};
    return {};
}

} // namespace franken
