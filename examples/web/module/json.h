// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace franken::web {

/// Writes JSON for the page, a piece at a time; commas come by themselves. Who writes keeps begin and end
/// together.
class Json {
public:
    /// '{' or '[', and what closes it.
    Json& begin(char bracket);
    Json& end(char bracket);
    /// The name of the next value of an object.
    Json& key(std::string_view name);

    Json& value(std::string_view text);
    Json& value(const char* text) { return value(std::string_view(text)); }
    Json& value(bool is);
    Json& value(double number);
    Json& value(int number) { return raw(std::to_string(number)); }
    Json& value(unsigned number) { return raw(std::to_string(number)); }
    Json& value(unsigned long number) { return raw(std::to_string(number)); }

    /// JSON that was written elsewhere.
    Json& raw(std::string_view json);

    template<typename Value>
    Json& member(std::string_view name, const Value& what) {
        return key(name).value(what);
    }

    /// As many numbers as there are.
    template<typename Numbers>
    Json& numbers(const Numbers& all) {
        begin('[');
        for (const auto number : all)
            value(static_cast<double>(number));
        return end(']');
    }

    const std::string& text() const { return m_text; }

private:
    void separate();

    std::string m_text;
};

} // namespace franken::web
