// SPDX-License-Identifier: MIT
//
// libgpiod 1.6, of Debian 12. Its event descriptor reads edges one at a time and blocks, so it is asked
// first.
#include "line.h"

#include <gpiod.h>

#include <cerrno>
#include <poll.h>

namespace franken::platform {

namespace {

struct CloseChip {
    void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }
};
using Chip = std::unique_ptr<gpiod_chip, CloseChip>;

int biasFlag(Pull pull) {
    switch (pull) {
    case Pull::None:
        return GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE;
    case Pull::Up:
        return GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP;
    case Pull::Down:
        return GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
    case Pull::AsIs:
        break;
    }
    return 0;
}

class Line1 final : public GpioLine {
public:
    Line1(Chip chip, gpiod_line* line) : m_chip(std::move(chip)), m_line(line) {}
    ~Line1() override { gpiod_line_release(m_line); }

    int descriptor() const override { return gpiod_line_event_get_fd(m_line); }
    int value() override {
        const int value = gpiod_line_get_value(m_line);
        return value < 0 ? -errno : value;
    }
    int set(bool active) override { return gpiod_line_set_value(m_line, active ? 1 : 0) < 0 ? -errno : 0; }
    int readEdges(std::vector<ContactEdge>& edges) override;

private:
    Chip m_chip;
    gpiod_line* m_line;
};

int Line1::readEdges(std::vector<ContactEdge>& edges) {
    for (pollfd ready = {descriptor(), POLLIN, 0}; poll(&ready, 1, 0) == 1;) {
        if ((ready.revents & POLLIN) == 0)
            return -ENODEV;
        gpiod_line_event event = {};
        if (gpiod_line_event_read(m_line, &event) != 0)
            return -errno;
        edges.push_back({event.event_type == GPIOD_LINE_EVENT_RISING_EDGE,
                         std::chrono::seconds(event.ts.tv_sec) + std::chrono::nanoseconds(event.ts.tv_nsec)});
    }
    return 0;
}

} // namespace

std::optional<GpioChip> describeChip(const std::string& path) {
    const Chip chip(gpiod_chip_open(path.c_str()));
    if (!chip)
        return std::nullopt;
    return GpioChip{path, gpiod_chip_name(chip.get()), gpiod_chip_label(chip.get()),
                    gpiod_chip_num_lines(chip.get())};
}

std::unique_ptr<GpioLine> requestLine(const GpioSettings& settings) {
    Chip chip(gpiod_chip_open(settings.chip.c_str()));
    gpiod_line* line = chip ? gpiod_chip_get_line(chip.get(), settings.number) : nullptr;
    if (line == nullptr)
        return nullptr;
    const int flags =
        biasFlag(settings.pull) | (settings.activeLow ? int{GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW} : 0);
    constexpr const char* kConsumer = "frankenshader";
    const int result = settings.output
                           ? gpiod_line_request_output_flags(line, kConsumer, flags, *settings.output ? 1 : 0)
                           : gpiod_line_request_both_edges_events_flags(line, kConsumer, flags);
    if (result != 0)
        return nullptr;
    return std::make_unique<Line1>(std::move(chip), line);
}

} // namespace franken::platform
