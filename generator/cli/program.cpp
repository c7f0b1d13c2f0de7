// SPDX-License-Identifier: MIT
#include "program.h"

#include <charconv>
#include <iomanip>
#include <sstream>

namespace franken::cli {
namespace {

// File systems take 255 bytes; the longest extension is ".shader_test.part".
constexpr std::size_t kMaxFileName = 230;

} // namespace

Program::Program(const Permutation& canonical)
    : permutation(canonical),
      name(toName(canonical)),
      file(name.size() <= kMaxFileName ? name : toHex(toKey(canonical))),
      composed(compose(canonical)) {}

std::string toHex(Key key) {
    std::ostringstream text;
    text << "0x" << std::hex << std::setw(16) << std::setfill('0') << key;
    return text.str();
}

Result<Permutation> permutationOf(std::string_view hex) {
    const std::string_view digits = hex.substr(std::min<std::size_t>(2, hex.size())); // After "0x".
    Key key = 0;
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), key, 16);
    if (failed != std::errc() || end != digits.data() + digits.size())
        return Error{"permutation.key", std::string(hex), "this is no key",
                     "give one as 'frankenshader list --json' prints it"};
    return fromKey(key);
}

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
