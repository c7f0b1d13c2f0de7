// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/log.h"
#include "franken/renderer.h"
#include "franken/text_layout.h"

#include <memory>
#include <string>
#include <string_view>

/// Text on top of a frame, from TrueType fonts.
namespace FRANKEN_API franken {

/// A text of an OverlayText; no other handle of the process has its value.
enum class TextId : unsigned {};

/// A text, and where it stands.
struct Text {
    Font font;
    std::string utf8 = {}; ///< Lines end at '\n'.
    TextStyle style = {};  ///< Size, width and alignment.
    /// Of the block's upper left corner on the target's area, as its viewer sees it; pixels, rounded to whole
    /// ones.
    float x = 0, y = 0;
    /// Of the glyphs, alpha included; 0-1. Blended as overlay pictures are: where the shader encodes, the
    /// colour is the encoded one, and a pixel that a glyph half covers is the mean of the encoded values; a
    /// target that encodes by itself (Output::Linear) has the decoded colour, and blends in linear light.
    Float4 color{1, 1, 1, 1};
    bool visible = true; ///< Hidden texts cost nothing.
};

/// Pixels.
struct TextSize {
    /// Of a block.
    float width = 0, height = 0;
};

/// What an OverlayText may take.
struct OverlayTextOptions {
    /// Of the GPU, for the pictures of glyphs, of 1 MiB each; at least one. A quarter more is kept on the
    /// CPU.
    std::size_t maxBytes = std::size_t{4} << 20;
    Log log = {}; ///< Told of each missing or broken glyph once (of the first 100).
};

/// Texts that a renderer draws over its frames. Glyphs are rasterised once for each font and size, into
/// pictures of the renderer (addPicture()), which are updated in place: they count in its memory, are evicted
/// and come back after a lost context. A text whose glyphs are there already costs neither an upload nor an
/// allocation, a new glyph Font::bitmap() and an upload in the next draw(). All calls on the renderer's
/// thread.
class OverlayText {
public:
    /// The renderer outlives it.
    explicit OverlayText(Renderer& renderer, OverlayTextOptions options = {});
    ~OverlayText(); ///< Removes its pictures from the renderer.
    OverlayText(OverlayText&&) noexcept;
    OverlayText& operator=(OverlayText&&) noexcept;

    /// These need no context. Fail with "text.style" for sizes out of range and numbers that are not finite,
    /// with "text.memory" where the glyphs of all texts do not fit, with "font.size" for a glyph that is too
    /// large, and with "text.unknown" for a text that is not there. What fails changes nothing.
    Result<TextId> add(const Text& text);
    Result<void> set(TextId id, std::string_view utf8);
    Result<void> set(TextId id, const TextStyle& style);
    Result<void> setPlace(TextId id, float x, float y);
    Result<void> setColor(TextId id, const Float4& color);
    Result<void> setVisible(TextId id, bool visible);
    /// Of the block: TextLayout::width and height.
    Result<TextSize> sizeOf(TextId id) const;
    /// Nothing where it is not there. Its glyphs stay until others need their room.
    void remove(TextId id);

    /// Draws all visible texts, with one draw call for each picture of glyphs, one picture after the other:
    /// where texts of different pictures lie on each other, that order counts. Fails as
    /// Renderer::updatePicture() and drawOverlay().
    Result<void> draw(const DrawTarget& target);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace franken
