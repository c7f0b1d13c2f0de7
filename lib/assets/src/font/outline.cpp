// SPDX-License-Identifier: MIT
#include "font/outline.h"

#include <cmath>
#include <string>

namespace franken {
namespace {

Error glyphError(std::uint16_t glyph, const char* what) {
    return {"font.glyph", "glyph " + std::to_string(glyph), std::string("its outline is broken: ") + what,
            "get the font again from where it came from"};
}

/// Reads one after the other.
class Cursor {
public:
    Cursor(const FontTable& table, std::size_t at) : m_table(table), m_at(at) {}

    /// Whether all that was read was there.
    bool isInside() const { return m_at <= m_table.size(); }
    std::uint8_t u8() { return m_table.u8(advance(1)); }
    std::uint16_t u16() { return m_table.u16(advance(2)); }
    std::int16_t s16() { return m_table.s16(advance(2)); }
    std::int8_t s8() { return static_cast<std::int8_t>(u8()); }
    void skip(std::size_t bytes) { m_at += bytes; }

private:
    std::size_t advance(std::size_t bytes) { return (m_at += bytes) - bytes; }

    const FontTable& m_table;
    std::size_t m_at;
};

constexpr std::size_t kBox = 10; ///< The number of contours and the box, which is not used.

enum PointFlag : std::uint8_t {
    OnCurve = 1,
    ShortX = 2,
    ShortY = 4,
    Repeated = 8,
    SameOrPlusX = 16,
    SameOrPlusY = 32
};

/// One coordinate of all points, each relative to the one before.
void readCoordinates(Cursor& cursor, const std::vector<std::uint8_t>& flags, std::uint8_t isShort,
                     std::uint8_t isSameOrPlus, float OutlinePoint::*coordinate, OutlinePoint* points) {
    int value = 0;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if ((flags[i] & isShort) != 0)
            value += (flags[i] & isSameOrPlus) != 0 ? cursor.u8() : -cursor.u8();
        else if ((flags[i] & isSameOrPlus) == 0)
            value += cursor.s16();
        points[i].*coordinate = static_cast<float>(value);
    }
}

enum PartFlag : std::uint16_t {
    Words = 1,
    Offsets = 2,
    Scale = 8,
    More = 32,
    TwoScales = 64,
    Matrix = 128,
    ScaledOffset = 2048
};

/// A glyph that stands in another one.
struct Part {
    std::uint16_t flags = 0, glyph = 0;
    int first = 0, second = 0; ///< An offset in x and y, or a point of the whole and one of the part.
    float xx = 1, xy = 0, yx = 0, yy = 1;
};

float fixed(Cursor& cursor) { return static_cast<float>(cursor.s16()) / 16384; }

Part readPart(Cursor& cursor) {
    Part part;
    part.flags = cursor.u16();
    part.glyph = cursor.u16();
    const bool words = (part.flags & Words) != 0;
    if ((part.flags & Offsets) != 0) {
        part.first = words ? cursor.s16() : cursor.s8();
        part.second = words ? cursor.s16() : cursor.s8();
    } else {
        part.first = words ? cursor.u16() : cursor.u8();
        part.second = words ? cursor.u16() : cursor.u8();
    }
    if ((part.flags & Scale) != 0) {
        part.xx = part.yy = fixed(cursor);
    } else if ((part.flags & TwoScales) != 0) {
        part.xx = fixed(cursor);
        part.yy = fixed(cursor);
    } else if ((part.flags & Matrix) != 0) {
        part.xx = fixed(cursor);
        part.xy = fixed(cursor);
        part.yx = fixed(cursor);
        part.yy = fixed(cursor);
    }
    return part;
}

class OutlineReader {
public:
    explicit OutlineReader(const FontTables& tables) : m_tables(tables) {}

    /// Appends the glyph to the outline.
    Result<void> read(std::uint16_t glyph, int depth) {
        if (glyph >= m_tables.glyphs)
            return glyphError(glyph, "there is no such glyph");
        const std::size_t begin = m_tables.glyphOffsets[glyph], end = m_tables.glyphOffsets[glyph + 1U];
        const FontTable bytes = m_tables.outlines.part(begin, end - begin);
        const int contours = bytes.s16(0);
        if (contours == 0)
            return {};
        return contours > 0 ? readContours(bytes, glyph, static_cast<std::size_t>(contours))
                            : readParts(bytes, glyph, depth);
    }

    Outline outline;

private:
    Result<void> readContours(const FontTable& bytes, std::uint16_t glyph, std::size_t contours) {
        const std::size_t before = outline.points.size();
        Cursor cursor(bytes, kBox);
        std::size_t count = 0;
        for (std::size_t i = 0; i < contours; ++i) {
            const std::size_t end = std::size_t{cursor.u16()} + 1;
            if (end <= count || !cursor.isInside())
                return glyphError(glyph, "a contour ends before it begins");
            count = end;
            outline.ends.push_back(before + end);
        }
        if (before + count > kMaxOutlinePoints)
            return glyphError(glyph, "it has too many points");
        cursor.skip(cursor.u16()); // Hints.
        return readPoints(cursor, glyph, count);
    }

    Result<void> readPoints(Cursor cursor, std::uint16_t glyph, std::size_t count) {
        std::vector<std::uint8_t> flags;
        while (flags.size() < count && cursor.isInside()) {
            const std::uint8_t flag = cursor.u8();
            const std::size_t repeats = (flag & Repeated) != 0 ? cursor.u8() : 0;
            flags.insert(flags.end(), 1 + repeats, flag);
        }
        if (flags.size() != count)
            return glyphError(glyph, "its points are cut off");
        const std::size_t before = outline.points.size();
        outline.points.resize(before + count);
        OutlinePoint* const points = outline.points.data() + before;
        for (std::size_t i = 0; i < count; ++i)
            points[i].onCurve = (flags[i] & OnCurve) != 0;
        readCoordinates(cursor, flags, ShortX, SameOrPlusX, &OutlinePoint::x, points);
        readCoordinates(cursor, flags, ShortY, SameOrPlusY, &OutlinePoint::y, points);
        return cursor.isInside() ? Result<void>() : glyphError(glyph, "its points are cut off");
    }

    Result<void> readParts(const FontTable& bytes, std::uint16_t glyph, int depth) {
        if (depth >= kMaxOutlineDepth)
            return glyphError(glyph, "its parts are nested too deep, or in a cycle");
        const std::size_t whole = outline.points.size();
        Cursor cursor(bytes, kBox);
        for (bool more = true; more;) {
            const Part part = readPart(cursor);
            more = (part.flags & More) != 0;
            if (!cursor.isInside())
                return glyphError(glyph, "its parts are cut off");
            if (++m_parts > kMaxOutlineParts)
                return glyphError(glyph, "it has too many parts");
            const std::size_t first = outline.points.size();
            if (Result<void> read = this->read(part.glyph, depth + 1); !read)
                return read;
            if (!place(part, whole, first))
                return glyphError(glyph, "a part is hung on a point that is not there");
        }
        return {};
    }

    /// Moves the part's points, from `first` on, to where they belong in the whole, which begins at `whole`.
    bool place(const Part& part, std::size_t whole, std::size_t first) {
        for (std::size_t i = first; i < outline.points.size(); ++i) {
            OutlinePoint& point = outline.points[i];
            point = {part.xx * point.x + part.yx * point.y, part.xy * point.x + part.yy * point.y,
                     point.onCurve};
        }
        float x = static_cast<float>(part.first), y = static_cast<float>(part.second);
        if ((part.flags & Offsets) == 0) {
            const std::size_t of = whole + static_cast<std::size_t>(part.first),
                              on = first + static_cast<std::size_t>(part.second);
            if (of >= first || on >= outline.points.size())
                return false;
            x = outline.points[of].x - outline.points[on].x;
            y = outline.points[of].y - outline.points[on].y;
        } else if ((part.flags & ScaledOffset) != 0) {
            x *= std::hypot(part.xx, part.xy);
            y *= std::hypot(part.yx, part.yy);
        }
        for (std::size_t i = first; i < outline.points.size(); ++i) {
            outline.points[i].x += x;
            outline.points[i].y += y;
        }
        return true;
    }

    const FontTables& m_tables;
    std::size_t m_parts = 0;
};

} // namespace

Result<Outline> readOutline(const FontTables& tables, std::uint16_t glyph) {
    OutlineReader reader(tables);
    if (Result<void> read = reader.read(glyph, 0); !read)
        return read.error();
    return std::move(reader.outline);
}

} // namespace franken
