// SPDX-License-Identifier: MIT
#include "image/hdr.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include <glm/common.hpp>

#include "image/image_header.h"
#include "image/srgb_tables.h"

namespace franken {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr std::string_view kMagic = "#?";
constexpr float kMaxRadiance = 1e9f; ///< Ten times the sun in kcd/m^2; sums of all texels stay finite.
constexpr std::string_view kResave = "save it again as a Radiance .hdr with RGBE texels";

Error formatError(std::string what) { return {"hdr.format", "", std::move(what), std::string(kResave)}; }

/// Reads a file from front to back; what lies behind its end reads as nothing.
class Reader {
public:
    explicit Reader(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

    /// The next line without its end; empty at the end of the file.
    std::string_view line() {
        const char* text = reinterpret_cast<const char*>(m_bytes.data());
        const std::string_view rest(text, m_bytes.size());
        const std::size_t length = std::min(rest.find('\n'), rest.size());
        m_bytes = m_bytes.subspan(std::min(length + 1, rest.size()));
        return rest.substr(0, length);
    }

    /// The next `count` bytes, at least 1; none if there are fewer.
    std::span<const std::uint8_t> take(std::size_t count) {
        if (count > m_bytes.size())
            return {};
        const auto taken = m_bytes.first(count);
        m_bytes = m_bytes.subspan(count);
        return taken;
    }

    std::size_t left() const { return m_bytes.size(); }
    std::span<const std::uint8_t> rest() const { return m_bytes; }

private:
    std::span<const std::uint8_t> m_bytes;
};

/// Eats `prefix` and the number after it.
bool parseSize(std::string_view& text, std::string_view prefix, int& value) {
    if (!text.starts_with(prefix))
        return false;
    text.remove_prefix(prefix.size());
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc();
}

/// Reads up to the texels.
Result<FloatImage> readHeader(Reader& reader, int maxSize) {
    if (!reader.line().starts_with(kMagic))
        return formatError("this is no Radiance picture: it does not start with #?");
    for (std::string_view line = reader.line(); !line.empty(); line = reader.line()) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            return formatError("texels are not stored as RGBE: the FORMAT line is another");
    }
    FloatImage image;
    std::string_view size = reader.line();
    if (!parseSize(size, "-Y ", image.height) || !parseSize(size, " +X ", image.width) || !size.empty())
        return formatError("the line with the size is not \"-Y height +X width\"");
    if (image.width < 1 || image.height < 1 || image.width > maxSize || image.height > maxSize)
        return Error{"hdr.size", "",
                     "the picture is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                         " texels, the limit is " + std::to_string(maxSize),
                     "scale it down"};
    return image;
}

bool readPlainRow(Reader& reader, std::span<Rgbe> row) {
    const auto bytes = reader.take(4 * row.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        row[i / 4][i % 4] = bytes[i];
    return !bytes.empty();
}

/// One channel of a row: runs (a count above 128, a value) and stretches (a count, as many values).
bool readChannel(Reader& reader, std::span<Rgbe> row, std::size_t channel) {
    for (std::size_t x = 0; x < row.size();) {
        const auto head = reader.take(1);
        if (head.empty() || head[0] == 0)
            return false;
        const bool run = head[0] > 128;
        const std::size_t count = run ? head[0] - 128u : head[0];
        const auto values = reader.take(run ? 1 : count);
        if (values.empty() || count > row.size() - x)
            return false;
        for (std::size_t i = 0; i < count; ++i)
            row[x++][channel] = values[run ? 0 : i];
    }
    return true;
}

bool readRow(Reader& reader, std::span<Rgbe> row) {
    const auto head = reader.rest().first(std::min<std::size_t>(4, reader.left()));
    const bool packed = head.size() == 4 && head[0] == 2 && head[1] == 2 &&
                        (std::size_t{head[2]} << 8 | head[3]) == row.size() && row.size() >= 8;
    if (!packed)
        return readPlainRow(reader, row);
    reader.take(4);
    for (std::size_t channel = 0; channel < 4; ++channel)
        if (!readChannel(reader, row, channel))
            return false;
    return true;
}

glm::vec3 toRadiance(const Rgbe& texel) {
    if (texel[3] == 0)
        return glm::vec3(0);
    const float scale = std::ldexp(1.0f, texel[3] - 136);
    return clampedRadiance(glm::vec3(texel[0], texel[1], texel[2]) * scale);
}

} // namespace

bool isHdr(std::span<const std::uint8_t> file) {
    return file.size() >= kMagic.size() && file[0] == '#' && file[1] == '?';
}

bool isFinite(const glm::vec3& texel) {
    return std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b);
}

glm::vec3 clampedRadiance(const glm::vec3& texel) { return glm::clamp(texel, 0.0f, kMaxRadiance); }

Error memoryError(std::string where) {
    return {"sky.limit", std::move(where), "the sky needs more memory than the limit",
            "scale it down, or raise SkyLimits::maxMemoryBytes"};
}

Result<FloatImage> decodeHdr(std::span<const std::uint8_t> file, int maxSize, std::size_t maxBytes) {
    Reader reader(file);
    Result<FloatImage> image = readHeader(reader, maxSize);
    if (!image)
        return image;
    const std::size_t width = static_cast<std::size_t>(image->width);
    const std::size_t height = static_cast<std::size_t>(image->height);
    // No encoding of a row is shorter: so a small file cannot claim much memory.
    if (reader.left() / height < std::min(4 * width, 4 + width / 16))
        return formatError("the file is cut off");

    if (width * height * sizeof(glm::vec3) > maxBytes)
        return memoryError("");
    std::vector<Rgbe> row(width);
    image->texels.reserve(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        if (!readRow(reader, row))
            return formatError("row " + std::to_string(y) + " of the texels is broken or cut off");
        for (const Rgbe& texel : row)
            image->texels.push_back(toRadiance(texel));
    }
    return image;
}

Result<FloatImage> decodeSrgbImage(std::span<const std::uint8_t> file, int maxSize, std::size_t maxBytes) {
    const Result<ImageHeader> header = readImageHeader(file, maxSize);
    if (!header)
        return header.error();
    // The codes go from the decoder to an Image, and from there to floats.
    const std::size_t codes = header->pixelBytes(), floats = codes / 4 * sizeof(glm::vec3);
    if (codes + std::max(header->decodingBytes, floats) > maxBytes)
        return memoryError("");
    Result<Image> image8 = decodeImage(file, maxSize);
    if (!image8)
        return std::move(image8).error();
    const SrgbTables& tables = SrgbTables::get();
    FloatImage image{image8->width, image8->height, {}};
    image.texels.reserve(image8->rgba.size() / 4);
    for (std::size_t i = 0; i < image8->rgba.size(); i += 4)
        image.texels.emplace_back(tables.lightOf(image8->rgba[i]), tables.lightOf(image8->rgba[i + 1]),
                                  tables.lightOf(image8->rgba[i + 2]));
    return image;
}

} // namespace franken
