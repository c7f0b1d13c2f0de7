// SPDX-License-Identifier: MIT
// compose_from GLSL_DIR OUT_DIR NAME...: writes OUT_DIR/0.vert, 0.frag, 1.vert, ... from snippets that are
// read from a folder instead of the ones that are built in, so that a search can try others.
#include "franken/generator/compose.h"
#include "franken/snippet_folder.h"

#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: compose_from GLSL_DIR OUT_DIR NAME...\n";
        return 2;
    }
    const auto snippets = franken::readSnippets(argv[1]);
    if (!snippets) {
        std::cerr << toString(snippets.error()) << '\n';
        return 1;
    }
    for (int i = 3; i < argc; ++i) {
        const auto parsed = franken::parseName(argv[i]);
        const auto canonical =
            parsed ? franken::canonicalise(*parsed) : franken::Result<franken::Canonical>(parsed.error());
        if (!canonical) {
            std::cerr << toString(canonical.error()) << '\n';
            return 1;
        }
        const franken::Composed program = compose(canonical->permutation, *snippets);
        const std::string file = std::string(argv[2]) + "/" + std::to_string(i - 3);
        std::ofstream(file + ".vert") << program.vertex.text;
        std::ofstream(file + ".frag") << program.fragment.text;
    }
    return 0;
}
