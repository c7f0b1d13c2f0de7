// SPDX-License-Identifier: MIT
// Prints one number for the names, keys and texts of the covering set: same_bytes.sh builds this with the
// other compiler and expects the same number.
#include "franken/generator/compose.h"
#include "franken/generator/covering.h"

#include <cinttypes>
#include <cstdio>

int main() {
    std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a, 64 bits
    const auto add = [&](std::string_view text) {
        for (const char c : text)
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    };
    const auto set = franken::coveringSet();
    for (const franken::Permutation& permutation : set) {
        const franken::Composed program = franken::compose(permutation);
        add(franken::toName(permutation));
        add(franken::toHex(franken::toKey(permutation)));
        add(program.vertex.text);
        add(program.fragment.text);
    }
    std::printf("%zu programs, %016" PRIx64 "\n", set.size(), hash);
}
