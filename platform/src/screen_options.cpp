// SPDX-License-Identifier: MIT
#include "franken/platform/screen.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace franken::platform {

namespace {

/// In the order of the enumeration.
constexpr std::string_view kFormats[] = {"8888", "10bit", "565"};

constexpr int kMaxModeExtent = 16384;

/// Takes a positive number from the front of the text.
std::optional<int> takeNumber(std::string_view& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 1)
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

Error badModeline(std::string_view text, std::string what) {
    return Error{"screen.modeline", std::string(text), std::move(what),
                 "write the pixel clock in MHz, four numbers across, four down, and -hsync or +hsync, as cvt "
                 "prints it"};
}

bool rises(int a, int b, int c, int d) { return 0 < a && a < b && b < c && c <= d && d <= kMaxModeExtent; }

} // namespace

std::string_view toString(PixelFormat format) { return kFormats[static_cast<std::size_t>(format)]; }

Result<ModeRequest> parseModeRequest(std::string_view text) {
    const Error error{"screen.mode", std::string(text), "this is no mode", "write 1280x720 or 1280x720@50"};
    std::string_view rest = text;
    const std::optional<int> width = takeNumber(rest);
    if (!width || !rest.starts_with('x'))
        return error;
    rest.remove_prefix(1);
    const std::optional<int> height = takeNumber(rest);
    if (!height || *width > kMaxModeExtent || *height > kMaxModeExtent)
        return error;
    if (rest.empty())
        return ModeRequest{{*width, *height}, 0};
    if (!rest.starts_with('@'))
        return error;
    rest.remove_prefix(1);
    const std::optional<int> refresh = takeNumber(rest);
    if (!refresh || !rest.empty() || *refresh > 1000)
        return error;
    return ModeRequest{{*width, *height}, *refresh};
}

Result<Modeline> parseModeline(std::string_view text) {
    std::string_view numbers = text;
    if (const std::size_t quote = text.rfind('"'); quote != std::string_view::npos)
        numbers.remove_prefix(quote + 1);
    std::istringstream words{std::string(numbers)};
    words.imbue(std::locale::classic());
    Modeline line;
    double megahertz = 0;
    words >> megahertz >> line.width >> line.hsyncStart >> line.hsyncEnd >> line.htotal >> line.height >>
        line.vsyncStart >> line.vsyncEnd >> line.vtotal;
    if (!words)
        return badModeline(text, "nine numbers are needed");
    if (!(megahertz > 1 && megahertz < 2000))
        return badModeline(text, "the pixel clock is not between 1 and 2000 MHz");
    if (!rises(line.width, line.hsyncStart, line.hsyncEnd, line.htotal) ||
        !rises(line.height, line.vsyncStart, line.vsyncEnd, line.vtotal))
        return badModeline(text, "each four numbers must rise: size, start and end of the pulse, total");
    line.clock = static_cast<int>(std::lround(megahertz * 1000));
    for (std::string word; words >> word;) {
        std::transform(word.begin(), word.end(), word.begin(),
                       [](unsigned char c) { return std::tolower(c); });
        if (word == "+hsync")
            line.positiveHsync = true;
        else if (word == "+vsync")
            line.positiveVsync = true;
        else if (word != "-hsync" && word != "-vsync")
            return badModeline(text, "\"" + word + "\" is not known");
    }
    return line;
}

} // namespace franken::platform
