// SPDX-License-Identifier: MIT
#include "raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace price {
namespace {

constexpr std::int64_t kSubpixels = 256;
constexpr std::uint32_t kFarthest = (1U << 24U) - 1;

using Point = std::array<std::int64_t, 2>;
using Polygon = std::vector<glm::dvec4>;

/// What is left of a convex polygon where `distance` is 0 or more (Sutherland and Hodgman, "Reentrant polygon
/// clipping", 1974).
template<typename Distance>
Polygon clipped(const Polygon& polygon, Distance distance) {
    Polygon inside;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double here = distance(from), there = distance(to);
        if (here >= 0)
            inside.push_back(from);
        if ((here >= 0) != (there >= 0))
            inside.push_back(from + here / (here - there) * (to - from));
    }
    return inside;
}

/// Between the near and the far plane, and so far beside the target that toSubpixels() has room for it.
Polygon clippedToReach(const std::array<glm::dvec4, 3>& corners) {
    constexpr double kReach = 64; // Halves of the largest target: 532,480 pixels.
    Polygon polygon(corners.begin(), corners.end());
    const auto cut = [&polygon](const auto& distance) {
        if (!std::all_of(polygon.begin(), polygon.end(),
                         [&](const glm::dvec4& p) { return distance(p) >= 0; }))
            polygon = clipped(polygon, distance);
    };
    cut([](const glm::dvec4& p) { return p.w + p.z; });
    cut([](const glm::dvec4& p) { return p.w - p.z; });
    for (int axis = 0; axis < 2; ++axis)
        for (const double side : {-1.0, 1.0})
            cut([axis, side](const glm::dvec4& p) { return kReach * p.w - side * p[axis]; });
    return polygon;
}

std::int64_t toSubpixels(double pixels) {
    constexpr double kMost = 1 << 20; // Beyond any target; products of two still fit into 64 bits.
    return std::llround(std::clamp(pixels, -kMost, kMost) * kSubpixels);
}

std::int64_t cross(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// 1 where a pixel's centre on that edge of a counter-clockwise triangle is outside, so that of two triangles
/// that share it one has the pixel: a left or an upper edge has its pixels.
std::int64_t edgeBias(const Point& from, const Point& to) {
    const bool isLeft = to[1] < from[1], isUpper = to[1] == from[1] && to[0] < from[0];
    return isLeft || isUpper ? 0 : 1;
}

struct Range {
    int begin, end;
};

/// Rounded down, below 0 as well.
std::int64_t floorOf(std::int64_t value, std::int64_t unit) {
    return value >= 0 ? value / unit : -((-value + unit - 1) / unit);
}

/// The pixels whose centres can lie between the least and the greatest of three coordinates.
Range pixelsBetween(std::int64_t a, std::int64_t b, std::int64_t c, int size) {
    const auto clampedTo = [size](std::int64_t pixel) {
        return static_cast<int>(std::clamp<std::int64_t>(pixel, 0, size));
    };
    const std::int64_t half = kSubpixels / 2;
    const std::int64_t least = std::min({a, b, c}), most = std::max({a, b, c});
    return {clampedTo(floorOf(least - half, kSubpixels)), clampedTo(floorOf(most - half, kSubpixels) + 1)};
}

/// An edge function that is 0 or more inside.
struct Edge {
    Edge(const Point& from, const Point& to)
        : origin(from), dx(to[0] - from[0]), dy(to[1] - from[1]), bias(edgeBias(from, to)) {}

    std::int64_t at(const Point& p) const { return dx * (p[1] - origin[1]) - dy * (p[0] - origin[0]); }
    bool has(const Point& p) const { return at(p) >= bias; }

    Point origin;
    std::int64_t dx, dy, bias;
};

/// Of these columns, those where a pixel of the rows y and y + 1 can be inside of all edges.
Range columnsInside(const std::array<Edge, 3>& edges, int y, const Range& columns) {
    double begin = columns.begin, end = columns.end;
    for (const Edge& edge : edges) {
        const auto crossing = [&edge](int row) { // Of the edge with the row's centres, pixels.
            const double above = (row + 0.5) * kSubpixels - static_cast<double>(edge.origin[1]);
            const double slope = static_cast<double>(edge.dx) / static_cast<double>(edge.dy);
            return (static_cast<double>(edge.origin[0]) + above * slope) / kSubpixels;
        };
        if (edge.dy > 0) // One column to spare, for rounding.
            end = std::min(end, std::max(crossing(y), crossing(y + 1)) + 1);
        else if (edge.dy < 0)
            begin = std::max(begin, std::min(crossing(y), crossing(y + 1)) - 1);
    }
    return {static_cast<int>(std::min<double>(begin, columns.end)),
            static_cast<int>(std::ceil(std::max<double>(end, columns.begin)))};
}

} // namespace

Raster::Raster(int width, int height)
    : m_width(width),
      m_height(height),
      m_depth(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kFarthest) {
    assert(width > 0 && height > 0 && width <= 16384 && height <= 16384);
}

Footprint Raster::draw(const std::array<glm::dvec4, 3>& corners, Faces faces, Hides hides) {
    Footprint footprint;
    m_tiles.clear();
    const Polygon polygon = clippedToReach(corners);
    std::vector<Point> points;
    std::vector<double> depths;
    for (const glm::dvec4& p : polygon) {
        if (!(p.w > 0))
            return footprint;
        points.push_back(
            {toSubpixels((p.x / p.w + 1) * 0.5 * m_width), toSubpixels((p.y / p.w + 1) * 0.5 * m_height)});
        depths.push_back((p.z / p.w + 1) * 0.5);
    }
    for (std::size_t i = 2; i < points.size(); ++i) { // A fan.
        const std::int64_t area = cross(points[0], points[i - 1], points[i]);
        if (area == 0 || (faces == Faces::Front && area < 0) || (faces == Faces::Back && area > 0))
            continue;
        Window triangle{points[0], points[i - 1], points[i], {depths[0], depths[i - 1], depths[i], 0}};
        if (area < 0) {
            std::swap(triangle.b, triangle.c);
            std::swap(triangle.depth.y, triangle.depth.z);
        }
        footprint.area += 0.5 * static_cast<double>(std::abs(area)) / (kSubpixels * kSubpixels);
        drawWindow(triangle, hides, footprint);
        addTiles(triangle);
    }
    std::sort(m_tiles.begin(), m_tiles.end());
    m_tiles.erase(std::unique(m_tiles.begin(), m_tiles.end()), m_tiles.end());
    return footprint;
}

void Raster::drawWindow(const Window& triangle, Hides hides, Footprint& footprint) {
    const Edge ab(triangle.a, triangle.b), bc(triangle.b, triangle.c), ca(triangle.c, triangle.a);
    const Range columns = pixelsBetween(triangle.a[0], triangle.b[0], triangle.c[0], m_width),
                rows = pixelsBetween(triangle.a[1], triangle.b[1], triangle.c[1], m_height);
    const double scale = 1 / static_cast<double>(cross(triangle.a, triangle.b, triangle.c));
    const auto pixel = [&](int x, int y) -> int { // 0: outside; 1: hidden; 2: shaded.
        const Point centre = {x * kSubpixels + kSubpixels / 2, y * kSubpixels + kSubpixels / 2};
        if (!ab.has(centre) || !bc.has(centre) || !ca.has(centre))
            return 0;
        const double depth = scale * (static_cast<double>(bc.at(centre)) * triangle.depth.x +
                                      static_cast<double>(ca.at(centre)) * triangle.depth.y +
                                      static_cast<double>(ab.at(centre)) * triangle.depth.z);
        const auto rounded = static_cast<std::uint32_t>(std::lround(std::clamp(depth, 0.0, 1.0) * kFarthest));
        std::uint32_t& nearest = m_depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                         static_cast<std::size_t>(x)];
        if (rounded > nearest)
            return 1;
        if (hides == Hides::Behind)
            nearest = rounded;
        return 2;
    };
    for (int y = rows.begin - rows.begin % 2; y < rows.end; y += 2) {
        const Range within = columnsInside({ab, bc, ca}, y, columns);
        for (int x = within.begin - within.begin % 2; x < within.end; x += 2) {
            std::size_t covered = 0, shaded = 0;
            for (int row = std::max(y, rows.begin); row < std::min(y + 2, rows.end); ++row)
                for (int column = std::max(x, columns.begin); column < std::min(x + 2, columns.end);
                     ++column) {
                    const int state = pixel(column, row);
                    covered += state > 0 ? 1 : 0;
                    shaded += state > 1 ? 1 : 0;
                }
            footprint.covered += {covered, covered > 0 ? std::size_t{1} : 0};
            footprint.shaded += {shaded, shaded > 0 ? std::size_t{1} : 0};
        }
    }
}

// A tile that lies wholly on the outer side of an edge is not reached.
void Raster::addTiles(const Window& triangle) {
    constexpr std::int64_t kSize = kTile * kSubpixels;
    const int across = (m_width + kTile - 1) / kTile, down = (m_height + kTile - 1) / kTile;
    const std::array edges = {Edge(triangle.a, triangle.b), Edge(triangle.b, triangle.c),
                              Edge(triangle.c, triangle.a)};
    const auto tilesBetween = [&triangle](std::size_t axis, int count) { // Also those where it has no pixel.
        const auto [least, most] = std::minmax({triangle.a[axis], triangle.b[axis], triangle.c[axis]});
        const auto clampedTo = [count](std::int64_t tile) {
            return static_cast<int>(std::clamp<std::int64_t>(tile, 0, count));
        };
        return Range{clampedTo(floorOf(least, kSize)), clampedTo(floorOf(most, kSize) + 1)};
    };
    const Range columns = tilesBetween(0, across), rows = tilesBetween(1, down);
    for (int y = rows.begin; y < rows.end; ++y)
        for (int x = columns.begin; x < columns.end; ++x) {
            const std::int64_t left = x * kSize, lower = y * kSize;
            const bool isReached = std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
                return edge.at({edge.dy > 0 ? left : left + kSize, edge.dx > 0 ? lower + kSize : lower}) > 0;
            });
            if (isReached)
                m_tiles.push_back(y * across + x);
        }
}

Shaded Raster::drawBackground() {
    Shaded shaded;
    const auto isSeen = [this](int x, int y) {
        return x < m_width && y < m_height &&
               m_depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                       static_cast<std::size_t>(x)] == kFarthest;
    };
    for (int y = 0; y < m_height; y += 2)
        for (int x = 0; x < m_width; x += 2) {
            std::size_t pixels = 0;
            for (int corner = 0; corner < 4; ++corner)
                pixels += isSeen(x + corner % 2, y + corner / 2) ? 1 : 0;
            shaded += {pixels, pixels > 0 ? std::size_t{1} : 0};
        }
    return shaded;
}

} // namespace price
