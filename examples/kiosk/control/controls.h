// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/platform/gpio.h"
#include "franken/platform/input.h"
#include "kiosk/control/bindings.h"
#include "kiosk/control/gestures.h"
#include "kiosk/event_loop.h"

#include <functional>
#include <memory>

namespace kiosk {

/// Turns keys, fingers, buttons and the motion sensor into actions.
class Controls {
public:
    struct Handlers {
        std::function<void(Action)> act;
        std::function<void(double x, double y)> drag; ///< Parts of the picture.
        std::function<void(double factor)> zoom;
        std::function<void()> touched; ///< Somebody did something; called before the others.
        std::function<void(bool)> motion;
    };
    /// Where there is no seat, no udev or no GPIO, the log says so, and the rest works.
    Controls(EventLoop& loop, const Config& config, franken::platform::Rotation screen, Handlers handlers,
             franken::Log log);

    void configure(const Config& config) { m_actions = ActionTable(config); }
    void setScreenRotation(franken::platform::Rotation rotation);

private:
    void openInput(const Config& config, franken::platform::Rotation screen);
    void openGpio(const Config& config);
    void inputReadable();
    void gpioReadable();
    void perform(std::optional<Action> action);

    EventLoop& m_loop;
    Handlers m_handlers;
    franken::Log m_log;
    ActionTable m_actions;
    Gestures m_gestures;
    std::unique_ptr<franken::platform::Input> m_input;
    std::unique_ptr<franken::platform::GpioInputs> m_gpio;
    std::unique_ptr<EventLoop::Source> m_inputSource, m_gpioSource;
};

} // namespace kiosk
