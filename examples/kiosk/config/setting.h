// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/config/config.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace kiosk {

/// When a changed setting takes effect.
enum class Takes { Effect, Restart };

template<typename T>
using Access = std::function<T&(Config&)>;

struct Switch {
    Access<bool> of;
};
struct Whole {
    Access<int> of;
    int least, most;
};
struct Number {
    Access<double> of;
    double least, most;
};

/// What is wrong with the text; nothing where it is good.
using Check = std::function<std::optional<std::string>(const std::string&)>;

struct Text {
    Access<std::string> of;
    std::vector<std::string> words = {}; ///< The only ones that there are; empty: any text.
    Check check = {};
    std::string form = {}; ///< For people: "WIDTHxHEIGHT".
    bool isPath = false;   ///< Relative ones are those of the file's folder.
};
struct TextList {
    Access<Texts> of;
    Check check = {}; ///< Of each.
    std::string form = {};
    bool isPath = false;
};

/// One row of the table from which the file's keys, the options, the documented example and the checks come.
struct Setting {
    std::string key; ///< "screen.output"
    std::variant<Switch, Whole, Number, Text, TextList> kind;
    std::string help;
    Takes takes = Takes::Effect;
};

/// All of them, by section, in the order of the example.
std::span<const Setting> settings();

/// Null for an unknown key.
const Setting* findSetting(std::string_view key);
/// The key that was probably meant; empty where none is near.
std::string nearestKey(std::string_view key);

/// What a section is for: the lines above it in the example.
std::string sectionHelp(std::string_view section);

/// The part of a key before its last dot, and the part behind it.
std::string sectionOf(const Setting& setting);
std::string nameOf(const Setting& setting);

/// A value as the file has it, before it is checked.
using RawValue = std::variant<bool, long long, double, std::string, Texts>;

/// Sets it, or says what is wrong with the value and changes nothing.
std::optional<std::string> assign(const Setting& setting, const RawValue& value, Config& config);

/// From the text of an option, in which a list is separated by spaces.
RawValue rawValueOf(const Setting& setting, const std::string& text);

/// The type and range, for people: "a number, 0 to 60".
std::string typeOf(const Setting& setting);

/// As TOML has it.
std::string valueText(const Setting& setting, const Config& config);

} // namespace kiosk
