// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/log.h"
#include "franken/platform/press.h"
#include "franken/result.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

/// Buttons, rotary encoders and outputs on GPIO lines, by libgpiod 1.6 or 2.x. Nothing here waits: poll the
/// descriptors and call dispatch() when they are readable.
///
/// A line that is missing, or that another program holds, is logged once and requested again every second
/// until it is available; so is a line whose chip disappears.
namespace franken {
namespace FRANKEN_API platform {

/// A line of a chip.
struct GpioPin {
    /// The line's number on the chip; on a Raspberry Pi the GPIO number that its documentation and `pinout`
    /// give: 17 is GPIO17 (pin 11 of the header) on every model.
    unsigned number = 0;
    /// The chip's label, name or path ("pinctrl-bcm2711", "gpiochip0"). Empty: the chip of the Pi's header,
    /// found by its label, because numbers of chips and names of lines differ between models and have changed
    /// during the Pi 5's life.
    std::string chip = {};
};

/// The resistor that the Pi switches to a line.
enum class Pull {
    None, ///< Off: there is a resistor outside.
    Up,   ///< For a button to ground.
    Down, ///< For a button to 3.3 V.
    AsIs  ///< As the device tree or another program left it.
};

/// A button, and how it is wired.
struct ButtonOptions {
    std::string name; ///< Name of its events.
    GpioPin pin;      ///< Where it is wired to.
    Pull pull = Pull::Up;
    bool activeLow = true;   ///< Pressed means 0 V.
    PressOptions press = {}; ///< What counts as a press.
};

/// A press of a button.
struct ButtonEvent {
    std::string name; ///< ButtonOptions::name.
    Press press;
    /// By the kernel's clock for edges. Comparable only with other times of this kind.
    std::chrono::nanoseconds time;
};

/// A rotary encoder, and how it is wired.
struct EncoderOptions {
    std::string name; ///< Name of its events.
    /// Its two contacts.
    GpioPin a, b;
    Pull pull = Pull::Up;
    bool activeLow = true;      ///< A closed contact means 0 V.
    int transitionsPerStep = 4; ///< 4 where it rests with both contacts open, 2 or 1 for others.
};

/// A turn of an encoder.
struct EncoderEvent {
    std::string name; ///< EncoderOptions::name.
    int steps;        ///< Positive where a leads b: clockwise, if it is wired as most are.
};

/// All buttons and encoders of a program.
class GpioInputs {
public:
    /// Never fails: lines that are missing are requested again.
    GpioInputs(std::vector<ButtonOptions> buttons, std::vector<EncoderOptions> encoders, Log log);
    ~GpioInputs();

    /// What happened since the last call.
    struct Events {
        std::vector<ButtonEvent> buttons;   ///< In their order.
        std::vector<EncoderEvent> encoders; ///< In their order.
    };

    /// Polls as readable when dispatch() has something to do.
    int descriptor() const;
    Events dispatch(); ///< Call it when the descriptor is readable, and when it has a timeout. Never waits.

    /// Whether all lines are there.
    bool complete() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// An output, for a lamp or a backlight's transistor.
class GpioOutput {
public:
    /// Never fails: every set() requests a missing line again.
    GpioOutput(GpioPin pin, bool activeLow, bool initial, Log log);
    ~GpioOutput();
    /// Fails with `gpio.busy`, `gpio.missing` or `gpio.driver`; the value is kept until the line is
    /// available.
    Result<void> set(bool on);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace platform
} // namespace franken
