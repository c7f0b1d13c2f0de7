// SPDX-License-Identifier: MIT
#include "kiosk/config/setting.h"

#include "franken/nearest.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace kiosk {

namespace {

using Fault = std::optional<std::string>;

std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\')
            out += '\\';
        out += letter;
    }
    return out + "\"";
}

std::string listText(const Texts& texts) {
    std::string out = "[";
    for (const std::string& text : texts)
        out += (out.size() > 1 ? ", " : "") + quoted(text);
    return out + "]";
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words)
        out += (out.empty() ? "" : ", ") + word;
    return out;
}

std::string nearestOf(const std::string& text, const std::vector<std::string>& words) {
    const std::vector<std::string_view> views(words.begin(), words.end());
    return std::string(franken::nearestWord(text, views));
}

Fault set(const Switch& kind, const RawValue& value, Config& config) {
    const bool* given = std::get_if<bool>(&value);
    if (given == nullptr)
        return "is neither true nor false";
    kind.of(config) = *given;
    return {};
}

Fault set(const Whole& kind, const RawValue& value, Config& config) {
    const long long* given = std::get_if<long long>(&value);
    if (given == nullptr)
        return "is not a whole number";
    if (*given < kind.least || *given > kind.most)
        return "is out of range: " + std::to_string(kind.least) + " to " + std::to_string(kind.most);
    kind.of(config) = static_cast<int>(*given);
    return {};
}

Fault set(const Number& kind, const RawValue& value, Config& config) {
    const long long* whole = std::get_if<long long>(&value);
    const double* given = std::get_if<double>(&value);
    if (whole == nullptr && given == nullptr)
        return "is not a number";
    const double number = whole != nullptr ? static_cast<double>(*whole) : *given;
    if (!(number >= kind.least && number <= kind.most))
        return "is out of range: " + numberText(kind.least) + " to " + numberText(kind.most);
    kind.of(config) = number;
    return {};
}

Fault set(const Text& kind, const RawValue& value, Config& config) {
    const std::string* given = std::get_if<std::string>(&value);
    if (given == nullptr)
        return "is not a text in quotes";
    if (!kind.words.empty() && std::find(kind.words.begin(), kind.words.end(), *given) == kind.words.end()) {
        const std::string nearest = nearestOf(*given, kind.words);
        return "is none of " + joined(kind.words) +
               (nearest.empty() ? "" : "; " + quoted(nearest) + " was probably meant");
    }
    if (!given->empty() && kind.check)
        if (Fault fault = kind.check(*given))
            return fault;
    kind.of(config) = *given;
    return {};
}

Fault set(const TextList& kind, const RawValue& value, Config& config) {
    const Texts* given = std::get_if<Texts>(&value);
    if (given == nullptr)
        return "is not a list of texts, [\"...\", \"...\"]";
    for (const std::string& each : *given)
        if (kind.check)
            if (Fault fault = kind.check(each))
                return ": " + quoted(each) + " " + *fault;
    kind.of(config) = *given;
    return {};
}

template<typename Value>
RawValue parsedOr(const std::string& text, RawValue other) {
    Value value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? RawValue(value) : other;
}

Texts wordsOf(const std::string& text) {
    std::istringstream stream(text);
    Texts words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

std::string formOf(const std::string& form, bool isPath, const char* otherwise) {
    if (!form.empty())
        return form;
    return isPath ? "a path" : otherwise;
}

struct TypeText {
    std::string operator()(const Switch&) const { return "true or false"; }
    std::string operator()(const Whole& kind) const {
        return "a whole number, " + std::to_string(kind.least) + " to " + std::to_string(kind.most);
    }
    std::string operator()(const Number& kind) const {
        return "a number, " + numberText(kind.least) + " to " + numberText(kind.most);
    }
    std::string operator()(const Text& kind) const {
        return kind.words.empty() ? formOf(kind.form, kind.isPath, "a text") : "one of " + joined(kind.words);
    }
    std::string operator()(const TextList& kind) const {
        return "a list: " + formOf(kind.form, kind.isPath, "texts");
    }
};

struct ValueText {
    Config& config;
    std::string operator()(const Switch& kind) const { return kind.of(config) ? "true" : "false"; }
    std::string operator()(const Whole& kind) const { return std::to_string(kind.of(config)); }
    std::string operator()(const Number& kind) const { return numberText(kind.of(config)); }
    std::string operator()(const Text& kind) const { return quoted(kind.of(config)); }
    std::string operator()(const TextList& kind) const { return listText(kind.of(config)); }
};

} // namespace

const Setting* findSetting(std::string_view key) {
    for (const Setting& setting : settings())
        if (setting.key == key)
            return &setting;
    return nullptr;
}

std::string nearestKey(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Setting& setting : settings())
        keys.push_back(setting.key);
    return std::string(franken::nearestWord(key, keys));
}

std::string sectionOf(const Setting& setting) { return setting.key.substr(0, setting.key.rfind('.')); }

std::string nameOf(const Setting& setting) { return setting.key.substr(setting.key.rfind('.') + 1); }

std::optional<std::string> assign(const Setting& setting, const RawValue& value, Config& config) {
    return std::visit([&](const auto& kind) { return set(kind, value, config); }, setting.kind);
}

RawValue rawValueOf(const Setting& setting, const std::string& text) {
    if (std::holds_alternative<Switch>(setting.kind) && (text == "true" || text == "false"))
        return text == "true";
    if (std::holds_alternative<Whole>(setting.kind))
        return parsedOr<long long>(text, text);
    if (std::holds_alternative<Number>(setting.kind))
        return parsedOr<double>(text, text);
    if (std::holds_alternative<TextList>(setting.kind))
        return wordsOf(text);
    return text;
}

std::string typeOf(const Setting& setting) { return std::visit(TypeText{}, setting.kind); }

std::string valueText(const Setting& setting, const Config& config) {
    Config copy = config; // Access is not const.
    return std::visit(ValueText{copy}, setting.kind);
}

} // namespace kiosk
