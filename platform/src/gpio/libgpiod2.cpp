// SPDX-License-Identifier: MIT
//
// libgpiod 2.x, of Debian 13. The kernel could debounce here, but does not with 1.6: one debouncer serves
// both.
#include "../owned.h"
#include "line.h"

#include <gpiod.h>

#include <cerrno>

namespace franken::platform {

namespace {

using Chip = Owned<gpiod_chip, gpiod_chip_close>;
using ChipInfo = Owned<gpiod_chip_info, gpiod_chip_info_free>;
using Settings = Owned<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owned<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owned<gpiod_request_config, gpiod_request_config_free>;
using Request = Owned<gpiod_line_request, gpiod_line_request_release>;
using Buffer = Owned<gpiod_edge_event_buffer, gpiod_edge_event_buffer_free>;

constexpr std::size_t kEdgesAtOnce = 64;

gpiod_line_bias biasOf(Pull pull) {
    switch (pull) {
    case Pull::None:
        return GPIOD_LINE_BIAS_DISABLED;
    case Pull::Up:
        return GPIOD_LINE_BIAS_PULL_UP;
    case Pull::Down:
        return GPIOD_LINE_BIAS_PULL_DOWN;
    case Pull::AsIs:
        break;
    }
    return GPIOD_LINE_BIAS_AS_IS;
}

gpiod_line_value valueOf(bool active) { return active ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE; }

class Line2 final : public GpioLine {
public:
    Line2(Request request, unsigned number) : m_request(std::move(request)), m_number(number) {}

    int descriptor() const override { return gpiod_line_request_get_fd(m_request.get()); }
    int value() override {
        const gpiod_line_value value = gpiod_line_request_get_value(m_request.get(), m_number);
        return value == GPIOD_LINE_VALUE_ERROR ? -errno : static_cast<int>(value);
    }
    int set(bool active) override {
        return gpiod_line_request_set_value(m_request.get(), m_number, valueOf(active)) != 0 ? -errno : 0;
    }
    int readEdges(std::vector<ContactEdge>& edges) override;

private:
    Request m_request;
    unsigned m_number;
    Buffer m_buffer{gpiod_edge_event_buffer_new(kEdgesAtOnce)};
};

int Line2::readEdges(std::vector<ContactEdge>& edges) {
    for (int more = 1; (more = gpiod_line_request_wait_edge_events(m_request.get(), 0)) != 0;) {
        const int count =
            more < 0 ? -1
                     : gpiod_line_request_read_edge_events(m_request.get(), m_buffer.get(), kEdgesAtOnce);
        if (count < 0)
            return -errno;
        for (int i = 0; i < count; ++i) {
            gpiod_edge_event* event =
                gpiod_edge_event_buffer_get_event(m_buffer.get(), static_cast<unsigned long>(i));
            edges.push_back({gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE,
                             std::chrono::nanoseconds(gpiod_edge_event_get_timestamp_ns(event))});
        }
    }
    return 0;
}

Settings toSettings(const GpioSettings& from) {
    Settings settings(gpiod_line_settings_new());
    gpiod_line_settings_set_active_low(settings.get(), from.activeLow);
    gpiod_line_settings_set_bias(settings.get(), biasOf(from.pull));
    if (from.output) {
        gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT);
        gpiod_line_settings_set_output_value(settings.get(), valueOf(*from.output));
    } else {
        gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT);
        gpiod_line_settings_set_edge_detection(settings.get(), GPIOD_LINE_EDGE_BOTH);
        gpiod_line_settings_set_event_clock(settings.get(), GPIOD_LINE_CLOCK_MONOTONIC);
    }
    return settings;
}

} // namespace

std::optional<GpioChip> describeChip(const std::string& path) {
    const Chip chip(gpiod_chip_open(path.c_str()));
    const ChipInfo info(chip ? gpiod_chip_get_info(chip.get()) : nullptr);
    if (!info)
        return std::nullopt;
    return GpioChip{path, gpiod_chip_info_get_name(info.get()), gpiod_chip_info_get_label(info.get()),
                    static_cast<unsigned>(gpiod_chip_info_get_num_lines(info.get()))};
}

std::unique_ptr<GpioLine> requestLine(const GpioSettings& settings) {
    const Chip chip(gpiod_chip_open(settings.chip.c_str()));
    if (!chip)
        return nullptr;
    const Settings lineSettings = toSettings(settings);
    const LineConfig lines(gpiod_line_config_new());
    gpiod_line_config_add_line_settings(lines.get(), &settings.number, 1, lineSettings.get());
    const RequestConfig config(gpiod_request_config_new());
    gpiod_request_config_set_consumer(config.get(), "frankenshader");
    Request request(gpiod_chip_request_lines(chip.get(), config.get(), lines.get()));
    if (!request)
        return nullptr;
    return std::make_unique<Line2>(std::move(request), settings.number);
}

} // namespace franken::platform
