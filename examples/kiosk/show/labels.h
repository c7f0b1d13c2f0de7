// SPDX-License-Identifier: MIT
#pragma once

#include "franken/overlay_text.h"
#include "kiosk/decide/wander.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kiosk {

/// What is to be read while the first model is loaded.
inline constexpr const char* kLoadingNotice = "Loading";

/// Texts over the picture: the model's name below, statistics at the upper left, and what happens while there
/// is nothing to show. They wander, so that they do not burn into the screen.
class Labels {
public:
    /// Without the font, there are no texts, and the log says so.
    Labels(franken::Renderer& renderer, const std::filesystem::path& font, franken::Log log);

    /// Empty: none.
    void setCaption(const std::string& text) { m_caption.text = text; }
    void setStatistics(const std::vector<std::string>& lines);
    void setNotice(const std::string& text) { m_notice.text = text; }
    /// Whether nothing is to be read.
    bool areEmpty() const {
        return !m_font || (m_caption.text.empty() && m_statistics.text.empty() && m_notice.text.empty());
    }

    /// `cover`: how much of the model, and of its name, the background hides.
    franken::Result<void> draw(const franken::DrawTarget& target, double cover, Shift shift);

private:
    struct Label {
        std::string text, shown;
        std::optional<franken::TextId> id;
        franken::TextSize size;
    };
    franken::Result<void> place(Label& label, const franken::TextStyle& style, float alpha);
    franken::Result<void> layOut(const franken::OverlayRect& area, float alpha, Shift shift);

    franken::Renderer& m_renderer;
    franken::OverlayText m_texts;
    std::optional<franken::Font> m_font;
    std::optional<franken::PictureId> m_sheet; ///< One white pixel: behind the statistics.
    Label m_caption, m_statistics, m_notice;
    float m_height = 0; ///< Of the picture that the texts were made for.
};

} // namespace kiosk
