// SPDX-License-Identifier: MIT
#include "program.h"

#include "effects.h"

#include <algorithm>

namespace franken::cli {
namespace {

// File systems take 255 bytes; the longest extension is ".shader_test.part".
constexpr std::size_t kMaxFileName = 230;

} // namespace

Program::Program(const Permutation& canonical)
    : permutation(canonical),
      name(toName(canonical, snippets())),
      file(name.size() <= kMaxFileName ? name : toHex(toKey(canonical))),
      composed(compose(canonical, snippets())) {}

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

} // namespace franken::cli
