// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <optional>

#include "franken/file.h"
#include "gltf/gate.h"

namespace franken::gltf {
namespace {

constexpr std::size_t kShownChars = 60;

int hexDigit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

Error uriError(std::string what) {
    return {"gltf.uri", "", std::move(what), "name a file next to the model, by a relative path"};
}

/// The characters of a URI's data, escapes decoded one by one, so that no copy of it is made.
class Characters {
public:
    explicit Characters(std::string_view text) : m_text(text) {}
    bool done() const { return m_at == m_text.size(); }
    char next() {
        const bool escape = m_text[m_at] == '%' && m_at + 2 < m_text.size() &&
                            hexDigit(m_text[m_at + 1]) >= 0 && hexDigit(m_text[m_at + 2]) >= 0;
        const char c = escape
                           ? static_cast<char>(hexDigit(m_text[m_at + 1]) * 16 + hexDigit(m_text[m_at + 2]))
                           : m_text[m_at];
        m_at += escape ? 3 : 1;
        return c;
    }

private:
    std::string_view m_text;
    std::size_t m_at = 0;
};

// RFC 3986, 2.1. A percent sign that begins no escape stays.
std::string decodePercent(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (Characters characters(text); !characters.done();)
        decoded += characters.next();
    return decoded;
}

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// RFC 4648, 4, and the URL's alphabet of its section 5. Mail folds lines: spaces between are no data.
Result<std::vector<std::uint8_t>> decodeBase64(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    unsigned digits = 0;
    bool padded = false;
    for (Characters characters(text); !characters.done();) {
        const char c = characters.next();
        if (isSpace(c))
            continue;
        const int digit = base64Digit(c);
        padded = padded || c == '=';
        if (padded ? c != '=' : digit < 0)
            return uriError("its data URI is not base64");
        if (padded)
            continue;
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if (const unsigned place = digits++ % 4; place != 0)
            bytes.push_back(static_cast<std::uint8_t>(bits >> (6 - place * 2)));
    }
    return bytes;
}

bool endsWithIgnoringCase(std::string_view text, std::string_view end) {
    return text.size() >= end.size() &&
           std::equal(end.begin(), end.end(), text.end() - static_cast<std::ptrdiff_t>(end.size()),
                      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

// RFC 2397: data:[type][;base64],data
Result<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri, std::size_t maxBytes) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        return uriError("its data URI has no data");
    if (uri.size() - comma > maxBytes)
        return Error{"file.size", "", "its data URI is larger than the limit of " + std::to_string(maxBytes),
                     ""};
    if (endsWithIgnoringCase(uri.substr(0, comma), ";base64"))
        return decodeBase64(uri.substr(comma + 1));
    const std::string plain = decodePercent(uri.substr(comma + 1));
    return std::vector<std::uint8_t>(plain.begin(), plain.end());
}

// RFC 3986, 5.2.4: the path without "." and "..", or nothing where it leaves the folder on the way.
std::optional<std::string> withoutDots(const std::string& path) {
    std::vector<std::string_view> segments;
    for (std::string_view rest = path; !rest.empty();) {
        const std::size_t slash = std::min(rest.find('/'), rest.size());
        const std::string_view segment = rest.substr(0, slash);
        rest.remove_prefix(std::min(slash + 1, rest.size()));
        if (segment == ".." && segments.empty())
            return std::nullopt;
        if (segment == "..")
            segments.pop_back();
        else if (!segment.empty() && segment != ".")
            segments.push_back(segment);
    }
    std::string joined;
    for (const std::string_view segment : segments)
        joined.append(joined.empty() ? "" : "/").append(segment);
    return joined;
}

Result<UriContents> readBelow(const std::filesystem::path& folder, const std::string& name,
                              std::size_t maxBytes) {
    const std::optional<std::string> inside = name.starts_with('/') ? std::nullopt : withoutDots(name);
    if (!inside || inside->empty())
        return Error{"file.outside", name, "the path leads out of the model's folder",
                     "put the file next to the model, and name it relative to that"};
    return findBelow(folder, *inside).and_then([&](const std::filesystem::path& file) {
        return readFile(file, maxBytes).transform([&](std::vector<std::uint8_t> bytes) {
            return UriContents{std::move(bytes), file};
        });
    });
}

} // namespace

bool isDataUri(const std::string& uri) {
    const auto start = std::find_if_not(uri.begin(), uri.end(), isSpace);
    const auto length = std::min<std::ptrdiff_t>(5, uri.end() - start);
    return endsWithIgnoringCase({start, start + length}, "data:");
}

Result<UriContents> readUri(const std::string& uri, const std::filesystem::path* folder,
                            std::size_t maxBytes) {
    if (isDataUri(uri))
        return decodeDataUri(uri, maxBytes).transform([](std::vector<std::uint8_t> bytes) {
            return UriContents{std::move(bytes), {}};
        });
    if (!folder)
        return uriError("it is in another file, " + uri.substr(0, kShownChars) + ", and there is no folder");
    std::string decoded = decodePercent(uri);
    // RFC 3986, 4.2: a colon in the first segment ends a scheme.
    const std::size_t colon = decoded.find(':');
    const bool hasScheme = colon != std::string::npos && colon < decoded.find('/');
    if (hasScheme || decoded.find('\0') != std::string::npos)
        return uriError("only files in the model's folder are read, and " + uri.substr(0, kShownChars) +
                        " is none");
    Result<UriContents> read = readBelow(*folder, decoded, maxBytes);
    if (read || decoded.find('\\') == std::string::npos)
        return read;
    std::replace(decoded.begin(), decoded.end(), '\\', '/');
    return readBelow(*folder, decoded, maxBytes);
}

} // namespace franken::gltf
