// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/light.h"
#include "franken/generator/pack.h"
#include "franken/result.h"

#include <optional>
#include <string>
#include <vector>

/// Parsers of settings that are texts. The checks of these settings call them as well.
namespace kiosk {

/// "R,G,B", each at least 0.
franken::Result<franken::Float3> parseColor(const std::string& text);

/// "X,Y,Z" or "X,Y,Z:R,G,B": where the light travels, and its colour times pi.
franken::Result<franken::Sun> parseSun(const std::string& text);

/// Minutes after midnight, of "HH:MM"; 24:00 is the end of a day.
franken::Result<int> parseClock(const std::string& text);

struct Hours {
    int from, to; ///< Minutes after midnight; `to` is behind `from`.
};
/// "HH:MM-HH:MM".
franken::Result<Hours> parseHours(const std::string& text);

struct Date {
    int year, month, day; ///< A year of 0: every year.
    bool operator==(const Date&) const = default;
};
/// "YYYY-MM-DD", or "MM-DD" for every year.
franken::Result<Date> parseDate(const std::string& text);

enum class PressKind { Short, Long, Double };
struct ButtonName {
    unsigned pin;
    PressKind press;
    bool operator==(const ButtonName&) const = default;
};
/// "GPIO17", "GPIO17:long" or "GPIO17:double".
franken::Result<ButtonName> parseButton(const std::string& text);

/// The code of <linux/input-event-codes.h> of "left", "space", "n", "f1", "5" and their like.
std::optional<unsigned> keyCode(const std::string& name);
std::vector<std::string> keyNames();

/// The error's sentence; nothing where there is a value.
template<typename T>
std::optional<std::string> faultOf(const franken::Result<T>& result) {
    return result ? std::optional<std::string>() : result.error().what;
}

} // namespace kiosk
