// SPDX-License-Identifier: MIT
#include "kiosk/machine/monitor.h"

#include "franken/file_writer.h"

#include <ctime>

namespace kiosk {

using franken::LogLevel;

namespace {

constexpr Time kLook = std::chrono::seconds(2);
constexpr Time kMetrics = std::chrono::seconds(15);

std::optional<double> bytesOf(std::optional<double> mebibytes) {
    return mebibytes ? std::optional(*mebibytes * (1 << 20)) : std::nullopt;
}

} // namespace

Monitor::Monitor(EventLoop& loop, const Config& config, Machine machine, Handlers handlers, franken::Log log)
    : m_machine(std::move(machine)),
      m_handlers(std::move(handlers)),
      m_log(std::move(log)),
      m_startSeconds(static_cast<double>(std::time(nullptr))),
      m_timer(loop.timer([this] { look(); })) {
    configure(config);
    m_timer->arm(now());
}

void Monitor::configure(const Config& config) {
    m_relief.configure({.hotCelsius = config.relief.hotCelsius,
                        .lowMebibytes = static_cast<double>(config.relief.lowMebibytes)});
    m_metrics = config.files.metrics;
}

void Monitor::look() {
    if (m_relief.observe(m_machine.strain(), now())) {
        m_log(LogLevel::Warning, m_relief.reason());
        m_handlers.relieved(m_relief);
    }
    if (now() >= m_nextMetrics) {
        m_nextMetrics = now() + kMetrics;
        writeMetrics();
    }
    m_timer->arm(now() + kLook);
}

Statistics statisticsOf(const Machine& machine) {
    Statistics statistics;
    statistics.residentBytes = bytesOf(residentMebibytes());
    statistics.freeContiguousBytes = bytesOf(machine.strain().freeMebibytes);
    statistics.celsius = machine.celsius();
    statistics.throttled = machine.throttled();
    return statistics;
}

Statistics Monitor::statistics() const {
    Statistics statistics = statisticsOf(m_machine);
    statistics.reliefStep = m_relief.step();
    statistics.startSeconds = m_startSeconds;
    m_handlers.report(statistics);
    return statistics;
}

void Monitor::writeMetrics() {
    if (m_metrics.empty() || m_task.runs())
        return;
    m_task.start([this, file = m_metrics, text = toPrometheus(statistics())] {
        // A power cut may lose one of these: syncing each would wear the card out.
        m_writing.note(franken::writeFile(file, text, franken::FileWriter::Sync::Later), m_log);
    });
}

} // namespace kiosk
