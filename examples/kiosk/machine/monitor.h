// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "kiosk/config/config.h"
#include "kiosk/decide/relief.h"
#include "kiosk/event_loop.h"
#include "kiosk/machine/machine.h"
#include "kiosk/report/background_task.h"
#include "kiosk/report/statistics.h"
#include "kiosk/report/trouble.h"

#include <functional>
#include <memory>

namespace kiosk {

/// The statistics that the machine knows; the others stay empty.
Statistics statisticsOf(const Machine& machine);

/// Measures the machine every few seconds, relieves it where it is too hot, and writes the statistics to
/// their file.
class Monitor {
public:
    struct Handlers {
        std::function<void(const Relief&)> relieved; ///< Its step has changed.
        std::function<void(Statistics&)> report;     ///< Adds what the machine does not know.
    };
    Monitor(EventLoop& loop, const Config& config, Machine machine, Handlers handlers, franken::Log log);

    void configure(const Config& config);
    const Relief& relief() const { return m_relief; }
    /// As of now.
    Statistics statistics() const;

private:
    void look();
    void writeMetrics();

    Machine m_machine;
    Handlers m_handlers;
    franken::Log m_log;
    Relief m_relief;
    std::string m_metrics;
    Trouble m_writing{"no statistics", "statistics are written again"};
    Time m_nextMetrics{0};
    double m_startSeconds;
    std::unique_ptr<EventLoop::Timer> m_timer;
    BackgroundTask m_task; ///< Last: it uses all of the above.
};

} // namespace kiosk
