// SPDX-License-Identifier: MIT
#include "../descriptor.h"
#include "line.h"

#include <algorithm>
#include <tuple>

namespace franken::platform {

namespace {

using namespace std::chrono_literals;

/// How often a missing line is asked for again, and a line that is there is asked whether it still is.
constexpr Nanoseconds kLookAgain = 1s;

/// A line that comes and goes. Says so to the log, once each time.
class KeptLine {
public:
    KeptLine(std::string name, GpioPin pin, GpioSettings settings)
        : m_name(std::move(name)), m_pin(std::move(pin)), m_settings(std::move(settings)) {}

    /// Whether it has just come.
    bool lookAgain(const Log& log);
    /// False where it has just gone.
    bool readEdges(std::vector<ContactEdge>& edges, const Log& log);
    /// Null while it is not there.
    GpioLine* line() const { return m_line.get(); }

private:
    void drop(const Log& log);
    void say(const Log& log, LogLevel level, const std::string& text) {
        if (log && text != std::exchange(m_said, text))
            log(level, m_name + ": " + text);
    }

    std::string m_name;
    GpioPin m_pin;
    GpioSettings m_settings;
    std::unique_ptr<GpioLine> m_line;
    std::string m_said;
};

bool KeptLine::lookAgain(const Log& log) {
    if (m_line && m_line->value() >= 0)
        return false;
    if (m_line)
        drop(log);
    Result<std::unique_ptr<GpioLine>> line = openLine(m_pin, m_settings);
    if (!line) {
        say(log, LogLevel::Warning, toString(line.error()));
        return false;
    }
    m_line = *std::move(line);
    if (!m_said.empty())
        say(log, LogLevel::Info, "the line is there");
    return true;
}

bool KeptLine::readEdges(std::vector<ContactEdge>& edges, const Log& log) {
    if (!m_line || m_line->readEdges(edges) == 0)
        return true;
    drop(log);
    return false;
}

void KeptLine::drop(const Log& log) {
    m_line.reset();
    say(log, LogLevel::Warning, "the line is gone");
}

struct Button {
    ButtonOptions options;
    KeptLine line;
    Debouncer debouncer{false, {}};
    PressRecogniser recogniser{{}};
    std::optional<Nanoseconds> settleAt = {}, expireAt = {};

    void restart();
    void take(const std::vector<ContactEdge>& edges, Nanoseconds now, std::vector<ButtonEvent>& events);
    void wait(Nanoseconds now, std::vector<ButtonEvent>& events);

private:
    void lasting(const ContactEdge& edge, Nanoseconds now, std::vector<ButtonEvent>& events);
    void tell(const std::vector<PressRecogniser::Event>& presses, std::vector<ButtonEvent>& events) const {
        for (const auto& [press, time] : presses)
            events.push_back({options.name, press, time});
    }
};

/// The line is new: what was half pressed is forgotten, and a level that it has now is no press.
void Button::restart() {
    debouncer = Debouncer(line.line()->value() == 1, options.press.settle);
    recogniser = PressRecogniser(options.press);
    settleAt.reset();
    expireAt.reset();
}

void Button::lasting(const ContactEdge& edge, Nanoseconds now, std::vector<ButtonEvent>& events) {
    std::vector<PressRecogniser::Event> presses;
    recogniser.edge(edge, presses);
    tell(presses, events);
    const std::optional<Nanoseconds> patience = recogniser.patience();
    expireAt = patience ? std::optional(now + *patience) : std::nullopt;
}

void Button::take(const std::vector<ContactEdge>& edges, Nanoseconds now, std::vector<ButtonEvent>& events) {
    for (const ContactEdge& raw : edges)
        if (const std::optional<ContactEdge> before = debouncer.edge(raw))
            lasting(*before, now, events);
    if (!edges.empty())
        settleAt = now + options.press.settle;
}

void Button::wait(Nanoseconds now, std::vector<ButtonEvent>& events) {
    if (settleAt && now >= *settleAt && line.line() != nullptr) {
        settleAt.reset();
        if (const std::optional<ContactEdge> change = debouncer.settled(line.line()->value() == 1))
            lasting(*change, now, events);
    }
    if (expireAt && now >= *expireAt && !debouncer.unsettled()) {
        expireAt.reset();
        std::vector<PressRecogniser::Event> presses;
        recogniser.expired(presses);
        tell(presses, events);
    }
}

struct Encoder {
    EncoderOptions options;
    KeptLine a, b;
    std::optional<EncoderDecoder> decoder;

    void lookAgain(const Log& log);
    void read(std::vector<EncoderEvent>& events, const Log& log);
};

void Encoder::lookAgain(const Log& log) {
    const bool aCame = a.lookAgain(log), bCame = b.lookAgain(log);
    if ((aCame || bCame) && a.line() != nullptr && b.line() != nullptr)
        decoder.emplace(a.line()->value() == 1, b.line()->value() == 1, options.transitionsPerStep);
}

void Encoder::read(std::vector<EncoderEvent>& events, const Log& log) {
    std::vector<ContactEdge> ofA, ofB;
    if (!a.readEdges(ofA, log) || !b.readEdges(ofB, log) || !decoder)
        return;
    std::vector<std::tuple<Nanoseconds, bool, bool>> all;
    for (const ContactEdge& edge : ofA)
        all.emplace_back(edge.time, false, edge.active);
    for (const ContactEdge& edge : ofB)
        all.emplace_back(edge.time, true, edge.active);
    std::sort(all.begin(), all.end());
    int steps = 0;
    for (const auto& [time, isB, active] : all)
        steps += decoder->edge(isB, active);
    if (steps != 0)
        events.push_back({options.name, steps});
}

} // namespace

struct GpioInputs::State {
    std::vector<Button> buttons;
    std::vector<Encoder> encoders;
    Log log;
    FileDescriptor poll = makePoll(), timer = makeTimer();
    Nanoseconds lookAgainAt{0};

    void lookAgain();
    void armTimer();
};

void GpioInputs::State::lookAgain() {
    const auto add = [&](const KeptLine& kept) { watch(poll, kept.line()->descriptor()); };
    for (Button& button : buttons)
        if (button.line.lookAgain(log)) {
            button.restart();
            add(button.line);
        }
    for (Encoder& encoder : encoders) {
        const GpioLine *a = encoder.a.line(), *b = encoder.b.line();
        encoder.lookAgain(log);
        if (encoder.a.line() != nullptr && encoder.a.line() != a)
            add(encoder.a);
        if (encoder.b.line() != nullptr && encoder.b.line() != b)
            add(encoder.b);
    }
    lookAgainAt = monotonicNow() + kLookAgain;
}

void GpioInputs::State::armTimer() {
    Nanoseconds next = lookAgainAt;
    for (const Button& button : buttons)
        for (const std::optional<Nanoseconds>& time : {button.settleAt, button.expireAt})
            if (time)
                next = std::min(next, *time);
    arm(timer, next);
}

GpioInputs::GpioInputs(std::vector<ButtonOptions> buttons, std::vector<EncoderOptions> encoders, Log log)
    : m_state(std::make_unique<State>()) {
    m_state->log = std::move(log);
    for (ButtonOptions& options : buttons) {
        const GpioSettings settings = {.activeLow = options.activeLow, .pull = options.pull};
        m_state->buttons.push_back({options, KeptLine(options.name, options.pin, settings)});
    }
    for (EncoderOptions& options : encoders) {
        const GpioSettings settings = {.activeLow = options.activeLow, .pull = options.pull};
        m_state->encoders.push_back({options, KeptLine(options.name + " a", options.a, settings),
                                     KeptLine(options.name + " b", options.b, settings), std::nullopt});
    }
    watch(m_state->poll, m_state->timer.get());
    m_state->lookAgain();
    m_state->armTimer();
}

GpioInputs::~GpioInputs() = default;

int GpioInputs::descriptor() const { return m_state->poll.get(); }

GpioInputs::Events GpioInputs::dispatch() {
    State& state = *m_state;
    Events events;
    drain(state.timer);
    const Nanoseconds now = monotonicNow();
    for (Button& button : state.buttons) {
        std::vector<ContactEdge> edges;
        button.line.readEdges(edges, state.log);
        button.take(edges, now, events.buttons);
        button.wait(now, events.buttons);
    }
    for (Encoder& encoder : state.encoders)
        encoder.read(events.encoders, state.log);
    if (now >= state.lookAgainAt)
        state.lookAgain();
    state.armTimer();
    return events;
}

bool GpioInputs::complete() const {
    return std::all_of(m_state->buttons.begin(), m_state->buttons.end(),
                       [](const Button& button) { return button.line.line() != nullptr; }) &&
           std::all_of(m_state->encoders.begin(), m_state->encoders.end(), [](const Encoder& encoder) {
               return encoder.a.line() != nullptr && encoder.b.line() != nullptr;
           });
}

struct GpioOutput::State {
    GpioPin pin;
    GpioSettings settings;
    Log log;
    std::unique_ptr<GpioLine> line;
};

GpioOutput::GpioOutput(GpioPin pin, bool activeLow, bool initial, Log log)
    : m_state(std::make_unique<State>()) {
    m_state->pin = std::move(pin);
    m_state->settings.activeLow = activeLow;
    m_state->log = std::move(log);
    if (const Result<void> done = set(initial); !done && m_state->log)
        m_state->log(LogLevel::Warning, toString(done.error()));
}

GpioOutput::~GpioOutput() = default;

Result<void> GpioOutput::set(bool on) {
    State& state = *m_state;
    state.settings.output = on;
    if (state.line && state.line->set(on) == 0)
        return {};
    state.line.reset();
    return openLine(state.pin, state.settings) // Sets it as well.
        .transform([&state](std::unique_ptr<GpioLine> line) { state.line = std::move(line); });
}

} // namespace franken::platform
