// SPDX-License-Identifier: MIT
// Where the pictures go.
#include "options.h"

#include "franken/file_writer.h"

#include <algorithm>
#include <string>

using namespace franken;

namespace {

std::string withZeros(int number, std::size_t digits) {
    std::string text = std::to_string(number);
    text.insert(0, digits - std::min(digits, text.size()), '0');
    return text;
}

/// The name with the number in place of its first %d, %4d or %04d; nothing where it has none.
std::optional<std::string> withNumber(const std::string& name, int number) {
    for (std::size_t begin = name.find('%'); begin != std::string::npos; begin = name.find('%', begin + 1)) {
        const std::size_t end = name.find_first_not_of("0123456789", begin + 1);
        constexpr std::size_t kMostDigits = 9;
        const std::size_t length = end == std::string::npos ? 0 : end - begin - 1;
        if (end == std::string::npos || name[end] != 'd' || length > 2)
            continue;
        const std::string digits = name.substr(begin + 1, length);
        const std::size_t width = digits.empty() ? 1 : std::stoul(digits);
        return name.substr(0, begin) + withZeros(number, std::min(width, kMostDigits)) + name.substr(end + 1);
    }
    return std::nullopt;
}

} // namespace

std::filesystem::path outputOf(const Options& options, int number) {
    const int count = std::max(options.turntable, options.frames);
    if (count == 0 || options.strip)
        return options.output;
    std::filesystem::path path = options.output;
    if (const auto name = withNumber(path.filename().string(), number + 1); name && options.frames > 0)
        return path.replace_filename(*name);
    const std::string text = withZeros(number + 1, std::to_string(count).size());
    path.replace_filename(path.stem().string() + "-" + text + path.extension().string());
    return path;
}

Result<void> checkOutputs(const Options& options, std::span<const std::filesystem::path> inputs) {
    for (int number = 0; number < std::max({options.turntable, options.frames, 1}); ++number)
        if (Result<void> checked = checkNotInput(outputOf(options, number), inputs); !checked)
            return checked;
    return {};
}
