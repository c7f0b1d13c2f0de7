// SPDX-License-Identifier: MIT
#include "franken/font.h"

#include "font/character_map.h"
#include "font/kerning.h"
#include "font/rasterise.h"
#include "font/tables.h"
#include "franken/file.h"

#include <algorithm>

namespace franken {

struct Font::Data {
    std::vector<std::uint8_t> file; ///< What the others look into.
    FontTables tables;
    CharacterMap characters;
    Kerning kerning;

    float ems(int units) const { return static_cast<float>(units) / static_cast<float>(tables.unitsPerEm); }
};

namespace {

constexpr float kBoxWidth = 0.5f, kBoxHeight = 0.7f, kBoxLine = 0.05f, kBoxSide = 0.05f; ///< ems

/// For a font that shows nothing for what it does not have: a hollow box.
Outline missingBox(float unitsPerEm) {
    Outline outline;
    const auto add = [&](float x, float y) {
        outline.points.push_back({x * unitsPerEm, y * unitsPerEm, true});
    };
    const float left = kBoxSide, right = kBoxWidth - kBoxSide;
    add(left, 0), add(left, kBoxHeight), add(right, kBoxHeight), add(right, 0);
    outline.ends.push_back(outline.points.size());
    add(left + kBoxLine, kBoxLine), add(right - kBoxLine, kBoxLine);
    add(right - kBoxLine, kBoxHeight - kBoxLine), add(left + kBoxLine, kBoxHeight - kBoxLine);
    outline.ends.push_back(outline.points.size());
    return outline;
}

} // namespace

float Font::ascent() const { return m_data->ems(m_data->tables.ascent); }
float Font::descent() const { return -m_data->ems(m_data->tables.descent); }
float Font::lineGap() const { return m_data->ems(m_data->tables.lineGap); }

std::uint16_t Font::glyphOf(char32_t code) const { return m_data->characters.glyphOf(code); }

float Font::advance(std::uint16_t glyph) const {
    const FontTables& tables = m_data->tables;
    if (glyph >= tables.glyphs)
        return 0;
    const int index = std::min<int>(glyph, tables.horizontalMetricsCount - 1);
    const std::uint16_t units = tables.horizontalMetrics.u16(4 * static_cast<std::size_t>(index));
    return glyph == 0 && units == 0 ? kBoxWidth : m_data->ems(units);
}

float Font::kerning(std::uint16_t left, std::uint16_t right) const {
    return m_data->ems(m_data->kerning.between(left, right));
}

Result<GlyphBitmap> Font::bitmap(std::uint16_t glyph, float pixels) const {
    const auto unitsPerEm = static_cast<float>(m_data->tables.unitsPerEm);
    Result<Outline> outline = readOutline(m_data->tables, glyph);
    if (glyph == 0 && (!outline || outline->points.empty()))
        outline = missingBox(unitsPerEm);
    if (!outline)
        return outline.error();
    return rasterise(*outline, std::clamp(pixels, kMinTextPixels, kMaxTextPixels) / unitsPerEm);
}

Result<Font> parseFont(std::vector<std::uint8_t> bytes, std::size_t maxBytes) {
    if (bytes.size() > maxBytes)
        return Error{"font.limit", "",
                     "the font has " + std::to_string(bytes.size()) + " bytes, the limit is " +
                         std::to_string(maxBytes),
                     "use a smaller font, or raise the limit"};
    auto data = std::make_shared<Font::Data>();
    data->file = std::move(bytes);
    Result<FontTables> tables = readFontTables(data->file);
    if (!tables)
        return tables.error();
    Result<CharacterMap> characters = CharacterMap::read(tables->characters, tables->glyphs);
    if (!characters)
        return characters.error();
    data->tables = *std::move(tables);
    data->characters = *std::move(characters);
    data->kerning = Kerning(data->tables.kerning, data->tables.positioning);
    return Font(std::move(data));
}

Result<Font> loadFont(const std::filesystem::path& file, std::size_t maxBytes) {
    Result<std::vector<std::uint8_t>> bytes = readFile(file, maxBytes);
    if (!bytes)
        return bytes.error();
    Result<Font> font = parseFont(*std::move(bytes), maxBytes);
    if (font)
        return font;
    Error error = font.error();
    error.where = file.string() + (error.where.empty() ? "" : ": " + error.where);
    return error;
}

} // namespace franken
