// SPDX-License-Identifier: MIT
#include "glyph_atlas.h"

#include <algorithm>
#include <string>

namespace franken {
namespace {

constexpr int kGap = 1; ///< Empty texels between glyphs and round the page: none is filtered into another.

/// Copies a rectangle between pictures of one byte a texel.
void copyRect(const std::uint8_t* from, int fromStride, std::uint8_t* to, int toStride, int width,
              int height) {
    for (int row = 0; row < height; ++row)
        std::copy_n(from + row * fromStride, width, to + row * toStride);
}

} // namespace

void GlyphAtlas::Rect::include(const Glyph& glyph) {
    left = std::min(left, glyph.x);
    top = std::min(top, glyph.y);
    right = std::max(right, glyph.x + glyph.width);
    bottom = std::max(bottom, glyph.y + glyph.height);
}

bool GlyphAtlas::place(Glyph& glyph, std::vector<Shelves>& shelves) const {
    for (std::size_t page = 0; page < m_maxPages; ++page) {
        if (page == shelves.size())
            shelves.emplace_back(kPageSize - kGap);
        if (const auto place = shelves[page].add(glyph.width + kGap, glyph.height + kGap)) {
            glyph.page = page;
            glyph.x = place->x + kGap;
            glyph.y = place->y + kGap;
            return true;
        }
    }
    return false;
}

void GlyphAtlas::addPages() {
    while (m_pages.size() < m_shelves.size())
        m_pages.push_back({std::make_shared<Coverage>(kPageBytes / 4), {}, {}});
}

// High glyphs first, so that shelves are full. Nothing changes before it is known that all of them fit.
bool GlyphAtlas::makeRoom(Glyph& added) {
    std::vector<std::pair<Glyph*, Glyph>> moves = {{&added, added}};
    for (auto& [key, glyph] : m_glyphs)
        if (glyph.uses > 0 && glyph.width > 0)
            moves.emplace_back(&glyph, glyph);
    std::stable_sort(moves.begin(), moves.end(),
                     [](const auto& a, const auto& b) { return a.second.height > b.second.height; });
    std::vector<Shelves> shelves;
    for (auto& [glyph, moved] : moves)
        if (!place(moved, shelves))
            return false;
    while (shelves.size() < m_pages.size())
        shelves.emplace_back(kPageSize - kGap);
    m_shelves = std::move(shelves);
    std::erase_if(m_glyphs, [](const auto& entry) { return entry.second.uses == 0; });
    std::erase_if(moves,
                  [&](const auto& move) { return move.first == &added ? added = move.second, true : false; });
    movePixels(moves);
    return true;
}

void GlyphAtlas::movePixels(const std::vector<std::pair<Glyph*, Glyph>>& moves) {
    addPages();
    std::vector<Coverage> before;
    for (Page& page : m_pages) {
        before.push_back(*page.coverage);
        std::fill(page.coverage->begin(), page.coverage->end(), std::uint8_t{0});
        page.changed = {0, 0, kPageSize, kPageSize};
    }
    for (const auto& [glyph, moved] : moves) {
        copyRect(before[glyph->page].data() + glyph->y * kPageSize + glyph->x, kPageSize,
                 m_pages[moved.page].coverage->data() + moved.y * kPageSize + moved.x, kPageSize, moved.width,
                 moved.height);
        *glyph = moved;
    }
}

Result<GlyphAtlas::Entry> GlyphAtlas::use(const Key& key, const Font& font) {
    if (const Entry known = m_glyphs.find(key); known != m_glyphs.end()) {
        ++known->second.uses;
        return known;
    }
    const Result<GlyphBitmap> bitmap = font.bitmap(key.glyph, key.pixels);
    if (!bitmap)
        return bitmap.error();
    Glyph glyph{.width = bitmap->width,
                .height = bitmap->height,
                .left = bitmap->left,
                .top = bitmap->top,
                .uses = 1};
    if (glyph.width > 0) {
        if (!place(glyph, m_shelves) && !makeRoom(glyph))
            return Error{"text.memory", "",
                         "the glyphs of all texts do not fit in " +
                             std::to_string(m_maxPages * kPageBytes >> 20U) + " MiB",
                         "remove texts, draw them smaller, or raise OverlayTextOptions::maxBytes"};
        addPages();
        Page& page = m_pages[glyph.page];
        copyRect(bitmap->coverage.data(), glyph.width, page.coverage->data() + glyph.y * kPageSize + glyph.x,
                 kPageSize, glyph.width, glyph.height);
        page.changed.include(glyph);
    }
    return m_glyphs.emplace(key, glyph).first;
}

void GlyphAtlas::release(Entry entry) {
    if (--entry->second.uses == 0 && entry->second.width == 0)
        m_glyphs.erase(entry); // It takes no room that would run out.
}

void GlyphAtlas::forget(unsigned font) {
    std::erase_if(m_glyphs, [font](const auto& entry) { return entry.first.font == font; });
}

Image GlyphAtlas::imageOf(const Coverage& coverage, const Rect& part) {
    Image image{"text", part.right - part.left, part.bottom - part.top, {}};
    image.rgba.assign(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                      255);
    std::uint8_t* alpha = image.rgba.data() + 3;
    for (int y = part.top; y < part.bottom; ++y)
        for (int x = part.left; x < part.right; ++x, alpha += 4)
            *alpha = coverage[static_cast<std::size_t>(y * kPageSize + x)];
    return image;
}

Result<void> GlyphAtlas::upload(Renderer& renderer, Page& page) {
    constexpr Rect kAll{0, 0, kPageSize, kPageSize};
    if (page.picture && page.changed.isEmpty())
        return {};
    if (page.picture) {
        const Rect part = page.changed;
        if (Result<void> updated =
                renderer.updatePicture(*page.picture, imageOf(*page.coverage, part), part.left, part.top);
            !updated)
            return updated;
    } else {
        const Result<PictureId> added = renderer.addPicture(
            imageOf(*page.coverage, kAll),
            [coverage = page.coverage, kAll]() -> Result<Image> { return imageOf(*coverage, kAll); });
        if (!added)
            return added.error();
        page.picture = *added;
    }
    page.changed = {};
    return {};
}

Result<void> GlyphAtlas::upload(Renderer& renderer) {
    for (Page& page : m_pages)
        if (Result<void> uploaded = upload(renderer, page); !uploaded)
            return uploaded;
    return {};
}

void GlyphAtlas::removePictures(Renderer& renderer) {
    for (Page& page : m_pages)
        if (page.picture)
            renderer.removePicture(*page.picture);
}

} // namespace franken
