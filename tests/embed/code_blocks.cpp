// SPDX-License-Identifier: MIT
// code_blocks PAGE.md OUT_DIR: writes each C++ block of the page to OUT_DIR/HEADING.inc, for a test that
// includes it, each block of command lines to OUT_DIR/HEADING.sh, for a test that runs it, and each block of
// GLSL to OUT_DIR/HEADING.glsl. HEADING is the heading above the block, in lower case with dashes ("a-sky");
// a second block of a language under one heading gets "-2". Compilers name the page and its line in their
// messages.
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string slugOf(const std::string& heading) {
    std::string slug;
    for (const char c : heading.substr(heading.find_first_not_of("# ")))
        slug += std::isalnum(static_cast<unsigned char>(c))
                    ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                    : '-';
    return slug;
}

/// The file of a block in that language; empty for other languages.
std::string fileOf(const std::string& fence, const std::string& heading, int number) {
    const std::string name = slugOf(heading) + (number > 1 ? "-" + std::to_string(number) : "");
    if (fence == "```cpp")
        return name + ".inc";
    if (fence == "```glsl")
        return name + ".glsl";
    return fence == "```sh" ? name + ".sh" : "";
}

/// How many blocks were written.
int writeBlocks(const fs::path& page, const fs::path& folder) {
    std::ifstream in(page);
    std::ofstream block;
    std::string heading;
    std::map<std::string, int> under; // Blocks by language and heading.
    int line = 0, written = 0;
    bool inCode = false;
    for (std::string text; std::getline(in, text);) {
        ++line;
        if (text.starts_with("```")) {
            inCode = !inCode;
            block.close();
            const std::string file = inCode ? fileOf(text, heading, under[text + heading] + 1) : "";
            if (file.empty())
                continue;
            ++under[text + heading];
            ++written;
            block.open(folder / file);
            if (file.ends_with(".inc"))
                block << "#line " << line + 1 << " \"" << page.string() << "\"\n";
        } else if (block.is_open()) {
            block << text << "\n";
        } else if (!inCode && text.starts_with("#")) {
            heading = text;
        }
    }
    return written;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: code_blocks PAGE.md OUT_DIR\n";
        return 2;
    }
    fs::create_directories(argv[2]);
    const int written = writeBlocks(argv[1], argv[2]);
    std::cout << written << " blocks of " << argv[1] << "\n";
    return written > 0 ? 0 : 1;
}
