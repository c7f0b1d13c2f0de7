// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>

#include "gltf_internal.h"

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

// RFC 4648, 4.
std::vector<std::uint8_t> decodeBase64(std::string_view text, std::string& problem) {
    while (!text.empty() && text.back() == '=')
        text.remove_suffix(1);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const int digit = base64Digit(text[i]);
        if (digit < 0) {
            problem = "its data URI is not base64";
            return {};
        }
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if (i % 4 != 0)
            bytes.push_back(static_cast<std::uint8_t>(bits >> (6 - i % 4 * 2)));
    }
    return bytes;
}

// RFC 2397: data:[type][;base64],data
std::vector<std::uint8_t> decodeDataUri(std::string_view uri, std::string& problem) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) {
        problem = "its data URI has no data";
        return {};
    }
    if (uri.substr(0, comma).ends_with(";base64"))
        return decodeBase64(uri.substr(comma + 1), problem);
    const std::string plain = decodePercent(uri.substr(comma + 1));
    return {plain.begin(), plain.end()};
}

bool isConfined(const std::filesystem::path& path) {
    return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

} // namespace

std::vector<std::uint8_t> readFile(const std::filesystem::path& path, std::size_t maxBytes,
                                   std::string& problem) {
    std::error_code error;
    const auto size =
        std::filesystem::is_regular_file(path, error) ? std::filesystem::file_size(path, error) : 0;
    std::ifstream file(path, std::ios::binary);
    if (error || !file || !std::filesystem::is_regular_file(path, error)) {
        problem = "the file " + path.filename().string() + " cannot be opened";
        return {};
    }
    if (size > maxBytes) {
        problem = "the file " + path.filename().string() + " has " + std::to_string(size) +
                  " bytes, over the limit of " + std::to_string(maxBytes);
        return {};
    }
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    if (size > 0 && !file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
        problem = "the file " + path.filename().string() + " cannot be read";
    return bytes;
}

std::vector<std::uint8_t> readUri(const std::string& uri, const std::filesystem::path& folder,
                                  std::size_t maxBytes, std::string& problem) {
    if (uri.starts_with("data:"))
        return decodeDataUri(uri, problem);
    const std::string decoded = decodePercent(uri);
    // RFC 3986, 4.2: a colon in the first segment ends a scheme.
    const std::size_t colon = decoded.find(':');
    const bool hasScheme = colon != std::string::npos && colon < decoded.find('/');
    if (hasScheme || decoded.find('\0') != std::string::npos || !isConfined(decoded)) {
        problem = "only files in the model's folder are read, and " + uri.substr(0, kShownChars) + " is none";
        return {};
    }
    return readFile(folder / decoded, maxBytes, problem);
}

} // namespace franken::gltf
