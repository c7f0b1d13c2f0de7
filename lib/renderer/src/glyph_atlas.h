// SPDX-License-Identifier: MIT
#pragma once

#include "franken/font.h"
#include "franken/overlay.h"
#include "franken/renderer.h"
#include "shelves.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace franken {

/// The glyphs that texts show, on pages that are overlay pictures: white, with the coverage as alpha. Calls
/// of a renderer are upload()'s alone.
class GlyphAtlas {
public:
    static constexpr int kPageSize = 512; ///< Texels a side; every GPU of these takes that.
    static constexpr std::size_t kPageBytes = 4 * std::size_t{kPageSize} * kPageSize;

    /// A glyph of a font at a size. `font`: any number of the caller's.
    struct Key {
        unsigned font;
        std::uint16_t glyph;
        float pixels;
        auto operator<=>(const Key&) const = default;
    };
    /// Where a glyph is: pixels of a page, and from the pen.
    struct Glyph {
        std::size_t page = 0;
        int x = 0, y = 0, width = 0, height = 0; ///< width 0: nothing to draw.
        int left = 0, top = 0;
        std::size_t uses = 0;
    };
    using Entry = std::map<Key, Glyph>::iterator;

    explicit GlyphAtlas(std::size_t maxBytes) : m_maxPages(std::max<std::size_t>(maxBytes / kPageBytes, 1)) {}

    /// The glyph, rasterised where it is new; counts as used until release(). Where there is no room, glyphs
    /// that nothing uses make room, and all others move. Fails with "text.memory", and as Font::bitmap().
    Result<Entry> use(const Key& key, const Font& font);
    void release(Entry entry);
    /// Drops the font's glyphs, which nothing uses.
    void forget(unsigned font);

    /// Brings what has changed to the GPU, into the pictures of the pages. Fails as Renderer::addPicture()
    /// and updatePicture(); the next call does what is left.
    Result<void> upload(Renderer& renderer);
    void removePictures(Renderer& renderer);

    std::size_t pages() const { return m_pages.size(); }
    /// Of a page that was uploaded.
    PictureId picture(std::size_t page) const { return *m_pages[page].picture; }

private:
    using Coverage = std::vector<std::uint8_t>;
    /// Of a page; empty at first.
    struct Rect {
        int left = kPageSize, top = kPageSize, right = 0, bottom = 0;
        void include(const Glyph& glyph);
        bool isEmpty() const { return left >= right; }
    };
    struct Page {
        std::shared_ptr<Coverage> coverage; ///< Shared with the picture's source.
        Rect changed;                       ///< Since the last upload.
        std::optional<PictureId> picture;
    };

    static Image imageOf(const Coverage& coverage, const Rect& part);
    bool place(Glyph& glyph, std::vector<Shelves>& shelves) const;
    bool makeRoom(Glyph& added);
    void movePixels(const std::vector<std::pair<Glyph*, Glyph>>& moves);
    void addPages();
    Result<void> upload(Renderer& renderer, Page& page);

    const std::size_t m_maxPages;
    std::vector<Shelves> m_shelves; ///< Of each page.
    std::vector<Page> m_pages;
    std::map<Key, Glyph> m_glyphs;
};

} // namespace franken
