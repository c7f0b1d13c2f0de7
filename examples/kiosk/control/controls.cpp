// SPDX-License-Identifier: MIT
#include "kiosk/control/controls.h"

#include <type_traits>

namespace kiosk {

namespace platform = franken::platform;
using franken::LogLevel;

namespace {

constexpr const char* kMotion = "motion";
// A sensor's line is up while the sensor sees somebody: its end counts as a short press, however long it was.
constexpr auto kEndless = std::chrono::hours(24 * 365);
constexpr auto kDoublePress = std::chrono::milliseconds(350);

std::optional<PressKind> kindOf(platform::Press press) {
    switch (press) {
    case platform::Press::Short:
        return PressKind::Short;
    case platform::Press::Long:
        return PressKind::Long;
    case platform::Press::Double:
        return PressKind::Double;
    case platform::Press::Down:
        break;
    }
    return {};
}

} // namespace

Controls::Controls(EventLoop& loop, const Config& config, platform::Rotation screen, Handlers handlers,
                   franken::Log log)
    : m_loop(loop), m_handlers(std::move(handlers)), m_log(std::move(log)), m_actions(config) {
    openInput(config, screen);
    openGpio(config);
}

void Controls::openInput(const Config& config, platform::Rotation screen) {
    platform::InputOptions options{.screen = screen, .grab = config.input.grab, .log = m_log};
    if (config.input.touchRotation != "screen")
        options.touch = platform::rotationOf(std::stoi(config.input.touchRotation));
    franken::Result<std::unique_ptr<platform::Input>> input = platform::Input::open(options);
    if (!input)
        return m_log(LogLevel::Warning, "no keys and no touch: " + franken::toString(input.error()));
    m_input = *std::move(input);
    m_inputSource = m_loop.onReadable(m_input->descriptor(), [this] { inputReadable(); });
    inputReadable();
}

void Controls::openGpio(const Config& config) {
    std::vector<platform::ButtonOptions> buttons;
    for (const unsigned pin : m_actions.pins()) {
        platform::ButtonOptions button{.name = std::to_string(pin), .pin = {.number = pin}};
        if (m_actions.isDoubled(pin))
            button.press.doublePress = kDoublePress;
        buttons.push_back(button);
    }
    if (config.presence.pin >= 0)
        buttons.push_back(
            {.name = kMotion,
             .pin = {.number = static_cast<unsigned>(config.presence.pin), .chip = config.presence.chip},
             .pull = platform::Pull::None,
             .activeLow = config.presence.activeLow,
             .press = {.longPress = kEndless}});
    if (buttons.empty())
        return;
    m_gpio = std::make_unique<platform::GpioInputs>(std::move(buttons),
                                                    std::vector<platform::EncoderOptions>(), m_log);
    m_gpioSource = m_loop.onReadable(m_gpio->descriptor(), [this] { gpioReadable(); });
}

void Controls::setScreenRotation(platform::Rotation rotation) {
    if (m_input)
        m_input->setScreenRotation(rotation);
}

void Controls::perform(std::optional<Action> action) {
    if (action)
        m_handlers.act(*action);
}

void Controls::inputReadable() {
    for (const platform::InputEvent& each : m_input->dispatch()) {
        if (std::holds_alternative<platform::DeviceEvent>(each))
            continue;
        m_handlers.touched();
        if (const auto* key = std::get_if<platform::KeyEvent>(&each); key != nullptr && key->down)
            perform(m_actions.ofKey(key->key));
        const auto* touch = std::get_if<platform::TouchEvent>(&each);
        if (touch == nullptr)
            continue;
        const Gestures::Moves moves = m_gestures.take(*touch);
        if (moves.dragX != 0 || moves.dragY != 0)
            m_handlers.drag(moves.dragX, moves.dragY);
        if (moves.zoom != 1)
            m_handlers.zoom(moves.zoom);
        for (const std::string& name : moves.names)
            perform(m_actions.ofGesture(name));
    }
}

void Controls::gpioReadable() {
    for (const platform::ButtonEvent& event : m_gpio->dispatch().buttons) {
        if (event.name == kMotion) {
            m_handlers.motion(event.press == platform::Press::Down);
            continue;
        }
        m_handlers.touched();
        if (const std::optional<PressKind> kind = kindOf(event.press))
            perform(m_actions.ofButton({static_cast<unsigned>(std::stoul(event.name)), *kind}));
    }
}

} // namespace kiosk
