// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

class Effect;
struct EffectChoice;

/// The snippets that programs are composed of. Most users need only the built-in set. Authors of snippets
/// load a folder, and load it again after an edit, without building.
///
/// An immutable value that is cheap to copy (one reference is counted), safe on any thread. A composed
/// program keeps no reference to its set.
class SnippetSet {
public:
    /// The files of generator/glsl, as they were at build time. The default of compose().
    static const SnippetSet& builtIn();

    /// The text of a snippet, as its file in generator/glsl has it; `name` is one of names().
    using Source = std::function<Result<std::string>(std::string_view name)>;

    /// The snippets of the recipe: "fragment/ambient/none" for fragment/ambient/none.glsl of generator/glsl.
    static std::vector<std::string> names();

    /// Makes a set of other texts (lib/programs reads them from a folder: snippet_folder.h). A text may
    /// differ from the built-in one, but its interface must be known to this build: attributes, uniforms and
    /// samplers can be left out, but new ones need a place in pack.h or texture_role.h, and so a build.
    ///
    /// Does not check whether the GLSL compiles; a driver does. Fails as `source` does, and, with file and
    /// line in `where`, with
    ///
    ///     snippet.syntax      breaks the contract of a snippet (generator/README.md)
    ///     snippet.interface   declares what no built-in snippet declares, or as another type
    ///
    /// `folder` names the source of the texts in errors and in the origins of lines.
    static Result<SnippetSet> make(const Source& source, std::string folder);

    /// Whether all snippets are those of the build; effects do not count.
    bool isBuiltIn() const;

    /// The set with one more effect, or with this one instead of another of its name, in that one's slot.
    /// Slots of others stay. Composes some programs with it and checks them as lint.h does. Fails with
    /// "effect.glsl" where they are not strict GLSL ES 1.00, and with "effect.many" beyond
    /// EffectChoice::kMaxSlot effects.
    Result<SnippetSet> with(const Effect& effect) const;

    /// By slot, from 1: effects()[0] has slot 1.
    std::span<const Effect> effects() const;

    /// How a permutation asks for the effect of that name. Fails with "effect.missing".
    Result<EffectChoice> chooseEffect(std::string_view name) const;

    /// The effect that was chosen in this set; null for none, and where the set has no such effect.
    const Effect* effectOf(const EffectChoice& choice) const;

    /// Whether the set can compose what was chosen. Fails with "effect.missing".
    Result<void> check(const EffectChoice& choice) const;

    /// All parts of programs; the generator's own business (src/library.h).
    struct Parts;
    const Parts& parts() const { return *m_parts; }

private:
    explicit SnippetSet(std::shared_ptr<const Parts> parts) : m_parts(std::move(parts)) {}

    std::shared_ptr<const Parts> m_parts;
};

} // namespace franken
