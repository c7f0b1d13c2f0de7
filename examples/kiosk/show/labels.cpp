// SPDX-License-Identifier: MIT
#include "kiosk/show/labels.h"

#include "kiosk/show/canvas.h"

#include <algorithm>
#include <utility>

namespace kiosk {

using franken::Result;

namespace {

// Heights of text and margins, as shares of the picture's.
constexpr float kCaptionHeight = 1.0f / 22, kStatisticsHeight = 1.0f / 36, kMargin = 1.0f / 24;

float pixelsOf(float share, float height) { return std::clamp(share * height, 9.0f, 120.0f); }

} // namespace

Labels::Labels(franken::Renderer& renderer, const std::filesystem::path& font, franken::Log log)
    : m_renderer(renderer), m_texts(renderer, {.log = log}) {
    Result<franken::Font> loaded = franken::loadFont(font);
    if (loaded)
        m_font = *std::move(loaded);
    else
        log(franken::LogLevel::Warning, "no texts are shown: " + franken::toString(loaded.error()));
    if (const auto sheet = addWhite(renderer))
        m_sheet = *sheet;
}

void Labels::setStatistics(const std::vector<std::string>& lines) {
    m_statistics.text.clear();
    for (const std::string& line : lines)
        m_statistics.text += (m_statistics.text.empty() ? "" : "\n") + line;
}

/// Makes the text anew where it has changed.
Result<void> Labels::place(Label& label, const franken::TextStyle& style, float alpha) {
    const franken::Float4 color{1, 1, 1, alpha};
    if (!label.id || label.shown != label.text) {
        if (label.id)
            m_texts.remove(*std::exchange(label.id, std::nullopt));
        const Result<franken::TextId> id =
            m_texts.add({.font = *m_font, .utf8 = label.text, .style = style, .color = color});
        if (!id)
            return id.error();
        label.id = *id;
        label.shown = label.text;
        label.size = m_texts.sizeOf(*id).value();
    }
    return m_texts.setColor(*label.id, color).and_then([&] {
        return m_texts.setVisible(*label.id, !label.text.empty());
    });
}

Result<void> Labels::layOut(const franken::OverlayRect& area, float alpha, Shift shift) {
    const float margin = kMargin * area.height;
    const auto dx = static_cast<float>(shift.x), dy = static_cast<float>(shift.y);
    const franken::TextStyle caption{.pixels = pixelsOf(kCaptionHeight, area.height),
                                     .width = area.width - 2 * margin,
                                     .align = franken::TextAlign::Center};
    for (const auto& [label, style, opacity] :
         {std::tuple<Label*, franken::TextStyle, float>{&m_caption, caption, alpha},
          {&m_statistics, {.pixels = pixelsOf(kStatisticsHeight, area.height)}, 1.0f},
          {&m_notice, caption, 1.0f}})
        if (Result<void> placed = place(*label, style, opacity); !placed)
            return placed;
    return m_texts.setPlace(*m_caption.id, margin + dx, area.height - margin - m_caption.size.height + dy)
        .and_then([&] { return m_texts.setPlace(*m_statistics.id, margin + dx, margin + dy); })
        .and_then([&] {
            return m_texts.setPlace(*m_notice.id, margin + dx,
                                    0.45f * area.height - m_notice.size.height + dy);
        });
}

Result<void> Labels::draw(const franken::DrawTarget& target, double cover, Shift shift) {
    if (areEmpty())
        return {};
    const franken::OverlayRect area = viewerArea(target);
    if (std::exchange(m_height, area.height) != area.height)
        for (Label* label : {&m_caption, &m_statistics, &m_notice})
            if (label->id)
                m_texts.remove(*std::exchange(label->id, std::nullopt));
    if (Result<void> laidOut = layOut(area, static_cast<float>(1 - cover), shift); !laidOut)
        return laidOut;
    if (m_sheet && !m_statistics.text.empty()) {
        const float margin = kMargin * area.height, border = 0.4f * margin;
        const franken::OverlayQuad behind{.picture = *m_sheet,
                                          .place = {margin + static_cast<float>(shift.x) - border,
                                                    margin + static_cast<float>(shift.y) - border,
                                                    m_statistics.size.width + 2 * border,
                                                    m_statistics.size.height + 2 * border},
                                          .color = {0, 0, 0, 0.6f}};
        if (Result<void> drawn = m_renderer.drawOverlay({&behind, 1}, target); !drawn)
            return drawn;
    }
    return m_texts.draw(target);
}

} // namespace kiosk
