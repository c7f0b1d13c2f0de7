// SPDX-License-Identifier: MIT
// compose_from GLSL_DIR OUT_DIR NAME...: writes OUT_DIR/0.vert, 0.frag, 1.vert, ... from snippets that are
// read from a folder instead of the ones that are built in, so that a search can try others.
#include "franken/generator/compose.h"
#include "snippet.h"

#include <deque>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace fs = std::filesystem;

namespace {

fs::path snippetFolder;

std::vector<franken::SnippetFile> readSnippets() {
    static std::deque<std::string> texts;
    std::vector<franken::SnippetFile> files;
    for (const auto& entry : fs::recursive_directory_iterator(snippetFolder)) {
        if (entry.path().extension() != ".glsl")
            continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const fs::path name = fs::relative(entry.path(), snippetFolder).replace_extension();
        const std::string& kept = texts.emplace_back(text.str());
        files.push_back({texts.emplace_back(name.generic_string()), kept});
    }
    return files;
}

} // namespace

// Instead of the generated one, which stays in the archive.
std::span<const franken::SnippetFile> franken::embeddedSnippets() {
    static const std::vector<SnippetFile> files = readSnippets();
    return files;
}

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: compose_from GLSL_DIR OUT_DIR NAME...\n";
        return 2;
    }
    snippetFolder = argv[1];
    for (int i = 3; i < argc; ++i) {
        const auto parsed = franken::parseName(argv[i]);
        const auto canonical =
            parsed ? franken::canonicalise(*parsed) : franken::Result<franken::Canonical>(parsed.error());
        if (!canonical) {
            std::cerr << toString(canonical.error()) << '\n';
            return 1;
        }
        const franken::Composed program = compose(canonical->permutation);
        const std::string file = std::string(argv[2]) + "/" + std::to_string(i - 3);
        std::ofstream(file + ".vert") << program.vertex.text;
        std::ofstream(file + ".frag") << program.fragment.text;
    }
    return 0;
}
