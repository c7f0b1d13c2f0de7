// SPDX-License-Identifier: MIT
#include "kiosk/config/checks.h"

#include <linux/input-event-codes.h>

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace kiosk {

using franken::Error;
using franken::Float3;
using franken::Result;

namespace {

Error fault(std::string what) { return {"config.value", {}, std::move(what), {}}; }

/// Takes a number off the front of the text.
template<typename Number>
std::optional<Number> take(std::string_view& text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc())
        return {};
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool take(std::string_view& text, char expected) {
    if (!text.starts_with(expected))
        return false;
    text.remove_prefix(1);
    return true;
}

/// A number of exactly so many digits.
std::optional<int> takeDigits(std::string_view& text, std::size_t digits) {
    if (text.size() < digits || text.substr(0, digits).find_first_not_of("0123456789") != text.npos)
        return {};
    std::string_view part = text.substr(0, digits);
    text.remove_prefix(digits);
    return take<int>(part);
}

std::optional<Float3> takeThree(std::string_view& text) {
    Float3 three{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<float> number = i == 0 || take(text, ',') ? take<float>(text) : std::nullopt;
        if (!number || !std::isfinite(*number))
            return {};
        three[i] = *number;
    }
    return three;
}

std::optional<int> takeClock(std::string_view& text) {
    const std::optional<int> hour = takeDigits(text, 2);
    const std::optional<int> minute = hour && take(text, ':') ? takeDigits(text, 2) : std::nullopt;
    if (!minute || *minute > 59 || *hour * 60 + *minute > 24 * 60)
        return {};
    return *hour * 60 + *minute;
}

constexpr std::pair<const char*, unsigned> kKeys[] = {
    {"left", KEY_LEFT},
    {"right", KEY_RIGHT},
    {"up", KEY_UP},
    {"down", KEY_DOWN},
    {"space", KEY_SPACE},
    {"enter", KEY_ENTER},
    {"escape", KEY_ESC},
    {"tab", KEY_TAB},
    {"backspace", KEY_BACKSPACE},
    {"home", KEY_HOME},
    {"end", KEY_END},
    {"page-up", KEY_PAGEUP},
    {"page-down", KEY_PAGEDOWN},
    {"plus", KEY_KPPLUS},
    {"minus", KEY_MINUS},
    {"print", KEY_SYSRQ},
    {"f1", KEY_F1},
    {"f2", KEY_F2},
    {"f3", KEY_F3},
    {"f4", KEY_F4},
    {"f5", KEY_F5},
    {"f6", KEY_F6},
    {"f7", KEY_F7},
    {"f8", KEY_F8},
    {"f9", KEY_F9},
    {"f10", KEY_F10},
    {"f11", KEY_F11},
    {"f12", KEY_F12},
    {"play-pause", KEY_PLAYPAUSE},
    {"next-song", KEY_NEXTSONG},
    {"previous-song", KEY_PREVIOUSSONG},
    {"a", KEY_A},
    {"b", KEY_B},
    {"c", KEY_C},
    {"d", KEY_D},
    {"e", KEY_E},
    {"f", KEY_F},
    {"g", KEY_G},
    {"h", KEY_H},
    {"i", KEY_I},
    {"j", KEY_J},
    {"k", KEY_K},
    {"l", KEY_L},
    {"m", KEY_M},
    {"n", KEY_N},
    {"o", KEY_O},
    {"p", KEY_P},
    {"q", KEY_Q},
    {"r", KEY_R},
    {"s", KEY_S},
    {"t", KEY_T},
    {"u", KEY_U},
    {"v", KEY_V},
    {"w", KEY_W},
    {"x", KEY_X},
    {"y", KEY_Y},
    {"z", KEY_Z},
    {"0", KEY_0},
    {"1", KEY_1},
    {"2", KEY_2},
    {"3", KEY_3},
    {"4", KEY_4},
    {"5", KEY_5},
    {"6", KEY_6},
    {"7", KEY_7},
    {"8", KEY_8},
    {"9", KEY_9},
};

} // namespace

Result<Float3> parseColor(const std::string& text) {
    std::string_view rest = text;
    const std::optional<Float3> color = takeThree(rest);
    if (!color || !rest.empty())
        return fault("is not three numbers with commas between, R,G,B");
    for (const float part : *color)
        if (part < 0)
            return fault("has a negative part");
    return *color;
}

Result<franken::Sun> parseSun(const std::string& text) {
    constexpr Float3 kPi = {3.1415927f, 3.1415927f, 3.1415927f};
    std::string_view rest = text;
    const std::optional<Float3> direction = takeThree(rest);
    if (!direction)
        return fault("does not begin with three numbers, X,Y,Z");
    if (*direction == Float3{0, 0, 0})
        return fault("has no direction");
    franken::Sun sun{.direction = *direction, .color = kPi, .illuminance = 1};
    if (rest.empty())
        return sun;
    if (!take(rest, ':'))
        return fault("is not X,Y,Z:R,G,B");
    const Result<Float3> color = parseColor(std::string(rest));
    if (!color)
        return color.error();
    sun.color = *color;
    return sun;
}

Result<int> parseClock(const std::string& text) {
    std::string_view rest = text;
    const std::optional<int> minutes = takeClock(rest);
    if (!minutes || !rest.empty())
        return fault("is not a time, HH:MM");
    return *minutes;
}

Result<Hours> parseHours(const std::string& text) {
    std::string_view rest = text;
    const std::optional<int> from = takeClock(rest);
    const std::optional<int> to = from && take(rest, '-') ? takeClock(rest) : std::nullopt;
    if (!to || !rest.empty())
        return fault("is not HH:MM-HH:MM");
    if (*to <= *from)
        return fault("ends before it begins; hours over midnight are two, until 24:00 and from 00:00 on");
    return Hours{*from, *to};
}

Result<Date> parseDate(const std::string& text) {
    std::string_view rest = text;
    int year = 0;
    if (text.size() == 10) {
        year = takeDigits(rest, 4).value_or(0);
        if (year == 0 || !take(rest, '-'))
            return fault("is not YYYY-MM-DD or MM-DD");
    }
    constexpr std::array<int, 12> kDays = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const std::optional<int> month = takeDigits(rest, 2);
    const std::optional<int> day = month && take(rest, '-') ? takeDigits(rest, 2) : std::nullopt;
    if (!day || !rest.empty())
        return fault("is not YYYY-MM-DD or MM-DD");
    if (*month < 1 || *month > 12 || *day < 1 || *day > kDays[static_cast<std::size_t>(*month - 1)])
        return fault("is no day of the calendar");
    return Date{year, *month, *day};
}

Result<ButtonName> parseButton(const std::string& text) {
    constexpr std::string_view kPrefix = "GPIO";
    std::string_view rest = text;
    if (!rest.starts_with(kPrefix))
        return fault("is not GPIO and a number, as GPIO17");
    rest.remove_prefix(kPrefix.size());
    const std::optional<unsigned> pin = take<unsigned>(rest);
    if (!pin || *pin > 1023)
        return fault("is not GPIO and a number, as GPIO17");
    if (rest.empty() || rest == ":short")
        return ButtonName{*pin, PressKind::Short};
    if (rest == ":long")
        return ButtonName{*pin, PressKind::Long};
    if (rest == ":double")
        return ButtonName{*pin, PressKind::Double};
    return fault("has something behind the number that is neither short, long nor double");
}

std::optional<unsigned> keyCode(const std::string& name) {
    for (const auto& [word, code] : kKeys)
        if (name == word)
            return code;
    return {};
}

std::vector<std::string> keyNames() {
    std::vector<std::string> names;
    for (const auto& entry : kKeys)
        names.emplace_back(entry.first);
    return names;
}

} // namespace kiosk
