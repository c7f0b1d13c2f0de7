// SPDX-License-Identifier: MIT
#include "franken/overlay_text.h"

#include "franken/guard.h"
#include "glyph_atlas.h"
#include "handle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>

namespace franken {
namespace {

constexpr std::size_t kMaxTold = 100;

Error styleError(const char* what) {
    return {"text.style", "", what, "pass another value; nothing was changed"};
}

Result<void> check(const TextStyle& style) {
    if (!(style.pixels >= kMinTextPixels && style.pixels <= kMaxTextPixels))
        return styleError("the size of the em must be 4 to 256 pixels");
    if (!std::isfinite(style.width) || style.width < 0)
        return styleError("the width must be finite, and 0 or more");
    if (!std::isfinite(style.lineSpacing) || style.lineSpacing <= 0)
        return styleError("the line spacing must be finite, and above 0");
    return {};
}

Result<void> checkPlace(float x, float y) {
    return std::isfinite(x) && std::isfinite(y) ? Result<void>() : styleError("the place must be finite");
}

Result<void> checkColor(const Float4& color) {
    for (const float value : color)
        if (!std::isfinite(value))
            return styleError("the colour must be finite");
    return {};
}

Error unknownText() {
    return {"text.unknown", "", "there is no such text", "use what add() returned, until remove()"};
}

} // namespace

struct [[gnu::visibility("hidden")]] OverlayText::State {
    /// A glyph where it is drawn, from the block's corner to the pen.
    struct Drawn {
        GlyphAtlas::Entry glyph;
        float x, y;
    };
    struct Block {
        TextId id;
        Text text;
        unsigned font;
        std::vector<Drawn> glyphs;
        TextSize size;
    };
    /// Fonts by their number in the atlas's keys.
    struct NumberedFont {
        Font font;
        unsigned number;
        std::size_t uses;
    };

    State(Renderer & renderer_, OverlayTextOptions options)
        : renderer(renderer_), log(guardedLog(std::move(options.log))), atlas(options.maxBytes) {}

    Block* find(TextId id) {
        const auto found =
            std::find_if(blocks.begin(), blocks.end(), [id](const Block& block) { return block.id == id; });
        return found == blocks.end() ? nullptr : &*found;
    }

    NumberedFont& useFont(const Font& font) {
        auto found = std::find_if(fonts.begin(), fonts.end(),
                                  [&](const NumberedFont& known) { return known.font == font; });
        if (found == fonts.end())
            found = fonts.insert(fonts.end(), {font, ++lastFont, 0});
        ++found->uses;
        return *found;
    }

    void releaseFont(unsigned number) {
        const auto found = std::find_if(fonts.begin(), fonts.end(), [number](const NumberedFont& known) {
            return known.number == number;
        });
        if (--found->uses > 0)
            return;
        atlas.forget(number);
        std::erase_if(told, [number](const auto& entry) { return entry.first == number; });
        fonts.erase(found);
    }

    /// Allocates nothing where it was told before.
    void tell(const Block& block, char32_t code, const Error* error) {
        if (!log || told.size() >= kMaxTold || !told.insert({block.font, code}).second)
            return;
        char name[16];
        std::snprintf(name, sizeof name, "U+%04X", static_cast<unsigned>(code));
        log(LogLevel::Warning, std::string("text: a box is drawn for ") + name + ": " +
                                   (error == nullptr ? "the font does not have it" : toString(*error)));
    }

    /// One of the font's glyphs; where it is broken, what stands for a missing one.
    Result<GlyphAtlas::Entry> use(const Block& block, const PlacedGlyph& placed, float pixels) {
        if (placed.glyph == 0)
            tell(block, placed.code, nullptr);
        const auto useGlyph = [&](std::uint16_t glyph) {
            return atlas.use({block.font, glyph, pixels}, block.text.font);
        };
        Result<GlyphAtlas::Entry> entry = useGlyph(placed.glyph);
        if (entry || entry.error().code != "font.glyph")
            return entry;
        tell(block, placed.code, &entry.error());
        return useGlyph(0);
    }

    void release(std::vector<Drawn> & glyphs) {
        for (const Drawn& drawn : glyphs)
            atlas.release(drawn.glyph);
        glyphs.clear();
    }

    /// Lays the block's text out as it would be with these; what fails leaves it as it was.
    Result<void> update(Block & block, std::string_view utf8, const TextStyle& style) {
        release(next); // Of a call that ended for want of memory.
        layOut(block.text.font, utf8, style, layout);
        for (const PlacedGlyph& placed : layout.glyphs) {
            const Result<GlyphAtlas::Entry> entry = use(block, placed, style.pixels);
            if (!entry) {
                release(next);
                return entry.error();
            }
            next.push_back({*entry, placed.x, placed.y});
        }
        if (utf8 != block.text.utf8)
            block.text.utf8 = utf8;
        block.text.style = style;
        block.size = {layout.width, layout.height};
        block.glyphs.swap(next);
        release(next);
        return {};
    }

    void addQuads(const Block& block, std::size_t page) {
        constexpr auto kSize = static_cast<float>(GlyphAtlas::kPageSize);
        const float x = std::round(block.text.x), y = std::round(block.text.y);
        for (const Drawn& drawn : block.glyphs) {
            const GlyphAtlas::Glyph& glyph = drawn.glyph->second;
            if (glyph.page != page || glyph.width == 0)
                continue;
            const auto width = static_cast<float>(glyph.width), height = static_cast<float>(glyph.height);
            quads.push_back({atlas.picture(page),
                             {x + drawn.x + static_cast<float>(glyph.left),
                              y + drawn.y + static_cast<float>(glyph.top), width, height},
                             {static_cast<float>(glyph.x) / kSize, static_cast<float>(glyph.y) / kSize,
                              width / kSize, height / kSize},
                             block.text.color});
        }
    }

    Result<void> draw(const DrawTarget& target) {
        if (Result<void> uploaded = atlas.upload(renderer); !uploaded)
            return uploaded;
        quads.clear();
        for (std::size_t page = 0; page < atlas.pages(); ++page)
            for (const Block& block : blocks)
                if (block.text.visible)
                    addQuads(block, page);
        return renderer.drawOverlay(quads, target);
    }

    Renderer& renderer;
    const Log log;
    GlyphAtlas atlas;
    std::vector<Block> blocks;
    std::vector<NumberedFont> fonts;
    unsigned lastFont = 0;
    std::set<std::pair<unsigned, char32_t>> told; ///< Of which font and character.
    // Of the running call; members, so that frames allocate nothing.
    TextLayout layout;
    std::vector<Drawn> next;
    std::vector<OverlayQuad> quads;
};

OverlayText::OverlayText(Renderer& renderer, OverlayTextOptions options)
    : m_state(std::make_unique<State>(renderer, std::move(options))) {}

OverlayText::~OverlayText() {
    if (m_state)
        m_state->atlas.removePictures(m_state->renderer);
}

OverlayText::OverlayText(OverlayText&&) noexcept = default;
OverlayText& OverlayText::operator=(OverlayText&& other) noexcept {
    std::swap(m_state, other.m_state);
    return *this;
}

Result<TextId> OverlayText::add(const Text& text) {
    return guarded("OverlayText::add()", [&]() -> Result<TextId> {
        for (const Result<void>& checked :
             {check(text.style), checkPlace(text.x, text.y), checkColor(text.color)})
            if (!checked)
                return checked.error();
        const unsigned font = m_state->useFont(text.font).number;
        State::Block block{newHandle<TextId>(), text, font, {}, {}};
        if (Result<void> updated = m_state->update(block, text.utf8, text.style); !updated) {
            m_state->releaseFont(font);
            return updated.error();
        }
        m_state->blocks.push_back(std::move(block));
        return m_state->blocks.back().id;
    });
}

Result<void> OverlayText::set(TextId id, std::string_view utf8) {
    return guarded("OverlayText::set()", [&]() -> Result<void> {
        State::Block* const block = m_state->find(id);
        if (block == nullptr)
            return unknownText();
        return utf8 == block->text.utf8 ? Result<void>() : m_state->update(*block, utf8, block->text.style);
    });
}

Result<void> OverlayText::set(TextId id, const TextStyle& style) {
    return guarded("OverlayText::set()", [&]() -> Result<void> {
        State::Block* const block = m_state->find(id);
        if (block == nullptr)
            return unknownText();
        if (Result<void> checked = check(style); !checked)
            return checked;
        return m_state->update(*block, block->text.utf8, style);
    });
}

Result<void> OverlayText::setPlace(TextId id, float x, float y) {
    State::Block* const block = m_state->find(id);
    if (block == nullptr)
        return unknownText();
    Result<void> checked = checkPlace(x, y);
    if (checked) {
        block->text.x = x;
        block->text.y = y;
    }
    return checked;
}

Result<void> OverlayText::setColor(TextId id, const Float4& color) {
    State::Block* const block = m_state->find(id);
    if (block == nullptr)
        return unknownText();
    Result<void> checked = checkColor(color);
    if (checked)
        block->text.color = color;
    return checked;
}

Result<void> OverlayText::setVisible(TextId id, bool visible) {
    State::Block* const block = m_state->find(id);
    if (block == nullptr)
        return unknownText();
    block->text.visible = visible;
    return {};
}

Result<TextSize> OverlayText::sizeOf(TextId id) const {
    const State::Block* const block = m_state->find(id);
    return block == nullptr ? Result<TextSize>(unknownText()) : block->size;
}

void OverlayText::remove(TextId id) {
    State::Block* const block = m_state->find(id);
    if (block == nullptr)
        return;
    m_state->release(block->glyphs);
    const unsigned font = block->font;
    std::erase_if(m_state->blocks, [id](const State::Block& other) { return other.id == id; });
    m_state->releaseFont(font);
}

Result<void> OverlayText::draw(const DrawTarget& target) {
    return guarded("OverlayText::draw()", [&] { return m_state->draw(target); });
}

} // namespace franken
