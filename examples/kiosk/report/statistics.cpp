// SPDX-License-Identifier: MIT
#include "kiosk/report/statistics.h"

#include <array>
#include <cstdio>

namespace kiosk {

using franken::platform::SurfaceState;

namespace {

constexpr std::array<SurfaceState, 6> kStates = {SurfaceState::Ready,      SurfaceState::Blanked,
                                                 SurfaceState::NoScreen,   SurfaceState::Paused,
                                                 SurfaceState::Recovering, SurfaceState::Failed};
constexpr std::array<double, 3> kQuantiles = {0.5, 0.95, 0.99};

template<typename... Values>
std::string format(const char* form, Values... values) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), form, values...);
    return text.data();
}

class Writer {
public:
    void counter(const char* name, const char* help, double value) { one(name, help, "counter", value); }
    void gauge(const char* name, const char* help, std::optional<double> value) {
        if (value)
            one(name, help, "gauge", *value);
    }
    void head(const std::string& name, const char* help, const char* type) {
        m_text += "# HELP frankenshader_kiosk_" + name + " " + help + "\n# TYPE frankenshader_kiosk_" + name +
                  " " + type + "\n";
    }
    void sample(const std::string& name, double value) {
        m_text += "frankenshader_kiosk_" + name + format(" %.9g\n", value);
    }
    const std::string& text() const { return m_text; }

private:
    void one(const char* name, const char* help, const char* type, double value) {
        head(name, help, type);
        sample(name, value);
    }
    std::string m_text;
};

void writeFrames(Writer& writer, const FrameTimes& frames) {
    writer.head("frame_duration_seconds",
                "Time from the beginning of a frame until it was handed to the driver.", "summary");
    for (const double quantile : kQuantiles)
        if (const auto value = frames.percentile(100 * quantile))
            writer.sample(format("frame_duration_seconds{quantile=\"%g\"}", quantile), *value);
    writer.sample("frame_duration_seconds_sum", frames.seconds());
    writer.sample("frame_duration_seconds_count", static_cast<double>(frames.frames()));
    writer.counter("late_frames_total", "Frames that missed a refresh of the screen.",
                   static_cast<double>(frames.late()));
}

std::string optionalText(const char* form, std::optional<double> value) {
    return value ? format(form, *value) : std::string("-");
}

// Bit 0, too little voltage, is the doctor's to say.
const char* throttling(std::optional<unsigned> bits) {
    if (!bits)
        return "throttling -";
    return *bits & 0b1110 ? "throttled" : "not throttled";
}

} // namespace

std::string stateName(SurfaceState state) {
    const bool draws = state == SurfaceState::Ready || state == SurfaceState::Busy;
    return draws ? "drawing" : std::string(franken::platform::toString(state));
}

std::string toPrometheus(const Statistics& s) {
    Writer writer;
    writeFrames(writer, s.frames);
    writer.head("state", "What the kiosk does: 1 for the state that it is in.", "gauge");
    for (const SurfaceState state : kStates)
        writer.sample("state{state=\"" + stateName(state) + "\"}", stateName(state) == s.state ? 1 : 0);
    writer.gauge("models", "Models in the playlist.", static_cast<double>(s.models));
    writer.gauge("models_broken", "Models that are skipped because they cannot be read.",
                 static_cast<double>(s.modelsBroken));
    writer.counter("models_shown_total", "Models that were shown.", static_cast<double>(s.modelsShown));
    writer.counter("programs_linked_total", "Shader programs that were linked.",
                   static_cast<double>(s.programs));
    writer.counter("shader_compiles_total", "Shaders that were compiled.", static_cast<double>(s.compiles));
    writer.gauge("fallback_programs", "Programs that were replaced by simpler ones.",
                 static_cast<double>(s.fallbacks));
    writer.gauge("gpu_memory_bytes", "GPU memory for textures, meshes and targets.", s.gpuBytes);
    writer.gauge("gpu_memory_budget_bytes", "Most GPU memory that is used.", s.gpuBudgetBytes);
    writer.gauge("resident_memory_bytes", "Resident memory of the process.", s.residentBytes);
    writer.gauge("cma_free_bytes", "Contiguous memory that is free.", s.freeContiguousBytes);
    writer.gauge("temperature_celsius", "Temperature of the processor.", s.celsius);
    if (s.throttled) {
        writer.gauge("throttled", "Whether the firmware limits the processor's speed now.",
                     (*s.throttled & 0b1110) != 0 ? 1 : 0);
        writer.gauge("under_voltage", "Whether the supply voltage is too low now.",
                     (*s.throttled & 1) != 0 ? 1 : 0);
    }
    writer.gauge("relief_step", "How far resolution and frame rate are lowered, 0 to 4.", s.reliefStep);
    writer.gauge("start_time_seconds", "When the process started, since the epoch.", s.startSeconds);
    return writer.text();
}

std::vector<std::string> toLines(const Statistics& s) {
    constexpr double kMebi = 1 << 20;
    const auto milliseconds = [&s](double percent) {
        return 1000 * s.frames.percentile(percent).value_or(0);
    };
    const auto mebibytes = [](std::optional<double> bytes) {
        return bytes ? std::optional(*bytes / kMebi) : std::nullopt;
    };
    return {format("frame  %.1f ms  95%% %.1f  99%% %.1f  late %llu", milliseconds(50), milliseconds(95),
                   milliseconds(99), static_cast<unsigned long long>(s.frames.late())),
            format("models  %zu  broken %zu", s.models, s.modelsBroken),
            format("programs  %llu  compiles %llu  simpler %zu", static_cast<unsigned long long>(s.programs),
                   static_cast<unsigned long long>(s.compiles), s.fallbacks),
            format("GPU  %.0f of %.0f MiB  CMA free %s", s.gpuBytes / kMebi, s.gpuBudgetBytes / kMebi,
                   optionalText("%.0f MiB", mebibytes(s.freeContiguousBytes)).c_str()),
            "RSS  " + optionalText("%.0f MiB", mebibytes(s.residentBytes)),
            format("SoC  %s  %s", optionalText("%.0f °C", s.celsius).c_str(), throttling(s.throttled)),
            format("relief  %d of 4", s.reliefStep)};
}

} // namespace kiosk
