// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/log.h"
#include "franken/platform/rotation.h"
#include "franken/result.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Touch, keyboards and mice, by libinput. They may be plugged and unplugged at any time. Nothing here waits:
/// poll the descriptor and call dispatch() when it is readable.
namespace franken {
namespace FRANKEN_API platform {

/// How input devices are opened.
struct InputOptions {
    /// How the screen is mounted (Surface::rotation()): a touch sensor is taken to be mounted with it.
    Rotation screen = Rotation::None;

    /// How the touch sensor is mounted, as the viewer sees it, if not as the screen is. It replaces udev's
    /// calibration (LIBINPUT_CALIBRATION_MATRIX), so that nothing is turned twice; without it, udev's
    /// calibration is applied first and the screen's rotation second.
    std::optional<Rotation> touch = {};

    /// Take keyboards and touch exclusively, so that no other program (such as the console behind) reads
    /// them.
    bool grab = false;

    std::string seat = "seat0"; ///< The name that udev and logind use.
    Log log = {};               ///< Receives a message for each device that is plugged or unplugged.
};

/// A finger on the screen.
struct TouchEvent {
    /// What the finger does.
    enum class Kind {
        Down,
        Move,
        Up,
        Cancel ///< The touch does not count: the device was unplugged, or it was a palm.
    };
    Kind kind;
    int finger;                     ///< Which of several; a number that is used again after Up and Cancel.
    Point position;                 ///< As the viewer sees it; the last known for Up and Cancel.
    std::chrono::microseconds time; ///< By the kernel's monotonic clock.
};

/// A key that goes down or up.
struct KeyEvent {
    unsigned key;                   ///< A code of <linux/input-event-codes.h>: KEY_LEFT is 105.
    bool down;                      ///< Else it goes up.
    std::chrono::microseconds time; ///< By the kernel's monotonic clock.
};

/// A mouse that moves, or a button of it.
struct PointerEvent {
    Point moved = {};               ///< Pixels of the viewer's picture to the right and down, of a mouse.
    unsigned button = 0;            ///< BTN_LEFT is 0x110; 0 for motion.
    bool down = false;              ///< Of a button: else it goes up.
    std::chrono::microseconds time; ///< By the kernel's monotonic clock.
};

/// A device that was plugged or unplugged.
struct DeviceEvent {
    std::string name;              ///< As the device calls itself.
    bool plugged;                  ///< Else it was unplugged.
    bool touch, keyboard, pointer; ///< Its capabilities.
};

/// What dispatch() returns.
using InputEvent = std::variant<TouchEvent, KeyEvent, PointerEvent, DeviceEvent>;

/// All input devices of a seat.
class Input {
public:
    /// Fails with `input.not-built` where the library was built without libinput, and with `input.driver`
    /// where udev or the seat cannot be had. No device at all is no error.
    static Result<std::unique_ptr<Input>> open(const InputOptions& options);
    ~Input();

    int descriptor() const; ///< Polls as readable when dispatch() has something to do.
    /// All that happened since the last call, in its order. Never waits.
    std::vector<InputEvent> dispatch();

    /// Call it when the surface's rotation has changed.
    void setScreenRotation(Rotation rotation);

private:
    struct State;
    explicit Input(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace platform
} // namespace franken
