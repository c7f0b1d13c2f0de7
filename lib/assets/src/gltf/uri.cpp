// SPDX-License-Identifier: MIT
#include "franken/file.h"
#include "gltf/internal.h"

namespace franken::gltf {
namespace {

constexpr std::size_t kShownChars = 60;

int hexDigit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// RFC 3986, 2.1. A percent sign that begins no escape stays.
std::string decodePercent(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape =
            text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
        decoded += escape ? static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2])) : text[i];
        i += escape ? 2 : 0;
    }
    return decoded;
}

int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

Error uriError(std::string what) {
    return {"gltf.uri", "", std::move(what), "name a file next to the model, by a relative path"};
}

// RFC 4648, 4.
Result<std::vector<std::uint8_t>> decodeBase64(std::string_view text) {
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int digit = base64Digit(text[i]);
        if (digit < 0)
            return uriError("its data URI is not base64");
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if (i % 4 != 0)
            bytes.push_back(static_cast<std::uint8_t>(bits >> (6 - i % 4 * 2)));
    }
    return bytes;
}

// RFC 2397: data:[type][;base64],data
Result<std::vector<std::uint8_t>> decodeDataUri(std::string_view uri, std::size_t maxBytes) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        return uriError("its data URI has no data");
    if (uri.size() - comma > maxBytes)
        return Error{"file.size", "", "its data URI is larger than the limit of " + std::to_string(maxBytes),
                     ""};
    if (uri.substr(0, comma).ends_with(";base64"))
        return decodeBase64(uri.substr(comma + 1));
    const std::string plain = decodePercent(uri.substr(comma + 1));
    return std::vector<std::uint8_t>(plain.begin(), plain.end());
}

} // namespace

Result<std::vector<std::uint8_t>> readUri(const std::string& uri, const std::filesystem::path* folder,
                                          std::size_t maxBytes) {
    if (uri.starts_with("data:"))
        return decodeDataUri(uri, maxBytes);
    if (!folder)
        return uriError("it is in another file, " + uri.substr(0, kShownChars) + ", and there is no folder");
    const std::string decoded = decodePercent(uri);
    // RFC 3986, 4.2: a colon in the first segment ends a scheme.
    const std::size_t colon = decoded.find(':');
    const bool hasScheme = colon != std::string::npos && colon < decoded.find('/');
    if (hasScheme || decoded.find('\0') != std::string::npos)
        return uriError("only files in the model's folder are read, and " + uri.substr(0, kShownChars) +
                        " is none");
    const Result<std::filesystem::path> path = findBelow(*folder, decoded);
    return path ? readFile(*path, maxBytes) : path.error();
}

} // namespace franken::gltf
