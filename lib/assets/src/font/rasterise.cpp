// SPDX-License-Identifier: MIT
#include "font/rasterise.h"

#include <algorithm>
#include <cmath>

// Only its rasteriser is used, which sees no byte of a file: it takes a font's offsets for good.
#define STBTT_STATIC
#define STBTT_assert(condition) static_cast<void>(condition)
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

namespace franken {
namespace {

constexpr float kFlatness = 0.1f; ///< Pixels that a line may be away from its curve.

short units(float value) { return static_cast<short>(std::lround(std::clamp(value, -32767.0f, 32767.0f))); }

OutlinePoint middle(const OutlinePoint& a, const OutlinePoint& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, true};
}

/// Curves as the rasteriser wants them: from point to point.
class Path {
public:
    void add(std::span<const OutlinePoint> contour) {
        const OutlinePoint& first = contour.front();
        const OutlinePoint& last = contour.back();
        const OutlinePoint start = first.onCurve ? first : last.onCurve ? last : middle(first, last);
        append(STBTT_vmove, start, {});
        const OutlinePoint* control = nullptr;
        for (const OutlinePoint& point : contour.subspan(first.onCurve ? 1 : 0)) {
            if (point.onCurve)
                lineOrCurve(point, control);
            else if (control != nullptr)
                append(STBTT_vcurve, middle(*control, point), *control);
            control = point.onCurve ? nullptr : &point;
        }
        lineOrCurve(start, control);
    }

    std::vector<stbtt_vertex> vertices;

private:
    void lineOrCurve(const OutlinePoint& to, const OutlinePoint* control) {
        append(control == nullptr ? STBTT_vline : STBTT_vcurve, to,
               control == nullptr ? OutlinePoint{} : *control);
    }
    void append(unsigned char type, const OutlinePoint& to, const OutlinePoint& control) {
        vertices.push_back({units(to.x), units(to.y), units(control.x), units(control.y), 0, 0, type, 0});
    }
};

/// Whole pixels round all points, y downwards.
struct PixelBox {
    PixelBox(const Outline& outline, float scale) {
        const auto [minX, maxX] =
            std::minmax_element(outline.points.begin(), outline.points.end(),
                                [](const OutlinePoint& a, const OutlinePoint& b) { return a.x < b.x; });
        const auto [minY, maxY] =
            std::minmax_element(outline.points.begin(), outline.points.end(),
                                [](const OutlinePoint& a, const OutlinePoint& b) { return a.y < b.y; });
        left = static_cast<int>(std::floor(scale * static_cast<float>(units(minX->x))));
        right = static_cast<int>(std::ceil(scale * static_cast<float>(units(maxX->x))));
        top = static_cast<int>(std::floor(-scale * static_cast<float>(units(maxY->y))));
        bottom = static_cast<int>(std::ceil(-scale * static_cast<float>(units(minY->y))));
    }
    int left, right, top, bottom;
};

} // namespace

Result<GlyphBitmap> rasterise(const Outline& outline, float scale) {
    GlyphBitmap bitmap;
    if (outline.points.empty())
        return bitmap;
    const PixelBox box(outline, scale);
    bitmap.left = box.left;
    bitmap.top = box.top;
    bitmap.width = box.right - box.left;
    bitmap.height = box.bottom - box.top;
    if (bitmap.width == 0 || bitmap.height == 0)
        return GlyphBitmap{};
    if (bitmap.width > kMaxGlyphPixels || bitmap.height > kMaxGlyphPixels)
        return Error{"font.size", "",
                     "a glyph has " + std::to_string(bitmap.width) + " x " + std::to_string(bitmap.height) +
                         " pixels, more than " + std::to_string(kMaxGlyphPixels) + " a side",
                     "draw the text smaller"};
    bitmap.coverage.resize(static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height));
    Path path;
    std::size_t first = 0;
    for (const std::size_t end : outline.ends) {
        path.add(std::span(outline.points).subspan(first, end - first));
        first = end;
    }
    stbtt__bitmap target{bitmap.width, bitmap.height, bitmap.width, bitmap.coverage.data()};
    stbtt_Rasterize(&target, kFlatness, path.vertices.data(), static_cast<int>(path.vertices.size()), scale,
                    scale, 0, 0, bitmap.left, bitmap.top, 1, nullptr);
    return bitmap;
}

} // namespace franken
