// SPDX-License-Identifier: MIT
// Any text as a permutation's name: refused, or the same again after its canonical name and its key, with a
// text.
#include <string_view>

#include "franken/generator/compose.h"
#include "franken/generator/effect.h"
#include "franken/generator/permutation.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace franken;
    static const SnippetSet set = *SnippetSet::builtIn().with(*Effect::parse(
        "fog", "//! light\nvec3 onLight(vec3 color, vec3 toEye) {\n  return color + toEye;\n}\n",
        "fog.glsl"));
    const auto permutation = parseName({reinterpret_cast<const char*>(data), size}, set);
    if (!permutation) {
        require(permutation.error().code.starts_with("permutation.") ||
                    permutation.error().code.starts_with("effect."),
                "a documented code");
        return 0;
    }
    const auto again = parseName(toName(*permutation, set), set);
    require(again && *again == *permutation, "the name names the permutation");
    const auto unpacked = fromKey(toKey(*permutation), set);
    require(unpacked && *unpacked == *permutation, "the key is the permutation");
    const auto canonical = canonicalise(*permutation);
    if (!canonical)
        return 0;
    const auto twice = canonicalise(canonical->permutation);
    require(twice && twice->dropped.empty() && twice->permutation == canonical->permutation,
            "canonical stays canonical");
    const Composed program = compose(canonical->permutation, set);
    require(!program.vertex.text.empty() && !program.fragment.text.empty(), "both stages");
    return 0;
}
