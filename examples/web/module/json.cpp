// SPDX-License-Identifier: MIT
#include "json.h"

#include <cmath>
#include <cstdio>

namespace franken::web {

void Json::separate() {
    if (!m_text.empty() && m_text.find_last_of("{[:,") != m_text.size() - 1)
        m_text += ',';
}

Json& Json::begin(char bracket) {
    separate();
    m_text += bracket;
    return *this;
}

Json& Json::end(char bracket) {
    m_text += bracket;
    return *this;
}

Json& Json::key(std::string_view name) {
    value(name);
    m_text += ':';
    return *this;
}

Json& Json::value(std::string_view text) {
    separate();
    m_text += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            (m_text += '\\') += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            char escaped[8];
            std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(c));
            m_text += escaped;
        } else {
            m_text += c;
        }
    }
    m_text += '"';
    return *this;
}

Json& Json::value(bool is) {
    separate();
    m_text += is ? "true" : "false";
    return *this;
}

// JSON has no infinity: null.
Json& Json::value(double number) {
    separate();
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", number);
    m_text += std::isfinite(number) ? text : "null";
    return *this;
}

Json& Json::raw(std::string_view json) {
    separate();
    m_text += json;
    return *this;
}

} // namespace franken::web
