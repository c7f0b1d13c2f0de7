// SPDX-License-Identifier: MIT
#include "franken/text_layout.h"

#include "franken/index.h"
#include "franken/utf8.h"

#include <algorithm>
#include <cmath>

namespace franken {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr float kTabSpaces = 4;

/// A number out of range, or none, becomes the nearest one.
float inRange(float value, float least, float most) { return value >= least ? std::min(value, most) : least; }

/// Fills lines from left to right. All lengths are pixels.
class LineFiller {
public:
    LineFiller(const Font& font, const TextStyle& style, TextLayout& layout)
        : m_font(font),
          m_layout(layout),
          m_align(style.align),
          m_pixels(inRange(style.pixels, kMinTextPixels, kMaxTextPixels)),
          m_width(inRange(style.width, 0, 1e6f)),
          m_lineHeight(std::max(1.0f, std::round(inRange(style.lineSpacing, 0.01f, 100) * m_pixels *
                                                 (font.ascent() + font.descent() + font.lineGap())))),
          m_baseline(std::round(m_pixels * font.ascent())) {
        layout.glyphs.clear();
        layout.lines.clear();
    }

    void add(char32_t code) {
        if (code == '\n')
            endLine(m_layout.glyphs.size(), m_space.isAtEnd ? m_space.before : m_pen, m_pen);
        else if (code == ' ' || code == '\t')
            addSpace(code == '\t' ? kTabSpaces : 1);
        else if (!isUnseen(code))
            addGlyph(code);
    }

    void finish() {
        add('\n');
        for (const TextLayout::Line& line : m_layout.lines)
            m_layout.width = std::max(m_layout.width, std::ceil(line.width));
        if (m_width > 0)
            m_layout.width = m_width;
        m_layout.height = m_lineHeight * static_cast<float>(m_layout.lines.size());
        for (const TextLayout::Line& line : m_layout.lines)
            align(line);
    }

private:
    /// The last place where the line may be broken.
    struct Space {
        bool isThere = false, isAtEnd = false;
        std::size_t glyphs = 0;      ///< Before it.
        float before = 0, after = 0; ///< The pen.
    };

    std::size_t firstOfLine() const { return m_layout.lines.empty() ? 0 : m_layout.lines.back().end; }

    void addSpace(float count) {
        const std::uint16_t glyph = m_font.glyphOf(' ');
        if (!m_space.isAtEnd)
            m_space = {true, true, m_layout.glyphs.size(), m_pen, m_pen};
        m_pen += count * m_pixels * m_font.advance(glyph);
        m_space.after = m_pen;
        m_before = kNone;
    }

    void addGlyph(char32_t code) {
        const std::uint16_t glyph = m_font.glyphOf(code);
        const float advance = m_pixels * m_font.advance(glyph);
        if (m_before != kNone)
            m_pen += m_pixels * m_font.kerning(static_cast<std::uint16_t>(m_before), glyph);
        while (m_width > 0 && m_layout.glyphs.size() > firstOfLine() && m_pen + advance > m_width)
            wrap();
        m_layout.glyphs.push_back({code, glyph, m_pen, m_y});
        m_pen += advance;
        m_before = glyph;
        m_space.isAtEnd = false;
    }

    void wrap() {
        if (m_space.isThere && m_space.glyphs > firstOfLine())
            endLine(m_space.glyphs, m_space.before, m_space.after);
        else
            endLine(m_layout.glyphs.size(), m_pen, m_pen);
    }

    /// Glyphs from `end` on go to the next line, which begins where the pen was at `begin`.
    void endLine(std::size_t end, float width, float begin) {
        m_layout.lines.push_back({firstOfLine(), end, width});
        m_y += m_lineHeight;
        for (std::size_t i = end; i < m_layout.glyphs.size(); ++i) {
            m_layout.glyphs[i].x -= begin;
            m_layout.glyphs[i].y = m_y;
        }
        m_pen -= begin;
        m_space = {};
        m_before = kNone;
    }

    void align(const TextLayout::Line& line) {
        const float room = m_layout.width - line.width;
        const float left = m_align == TextAlign::Left ? 0 : m_align == TextAlign::Right ? room : room / 2;
        for (std::size_t i = line.first; i < line.end; ++i) {
            PlacedGlyph& glyph = m_layout.glyphs[i];
            glyph.x = std::round(glyph.x + left);
            glyph.y += m_baseline;
        }
    }

    const Font& m_font;
    TextLayout& m_layout;
    const TextAlign m_align;
    const float m_pixels, m_width, m_lineHeight, m_baseline;
    float m_pen = 0, m_y = 0;
    int m_before = kNone; ///< The glyph on the left.
    Space m_space;
};

} // namespace

void layOut(const Font& font, std::string_view text, const TextStyle& style, TextLayout& layout) {
    layout.width = layout.height = 0;
    LineFiller filler(font, style, layout);
    while (!text.empty()) {
        const CodePoint next = decodeUtf8(text);
        filler.add(next.bytes == 0 ? kReplacement : next.code);
        text.remove_prefix(std::max<std::size_t>(next.bytes, 1));
    }
    filler.finish();
}

} // namespace franken
