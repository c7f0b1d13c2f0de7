// SPDX-License-Identifier: MIT
#include "franken/platform/input.h"

#ifdef FRANKEN_LIBINPUT

#include "owned.h"

#include <libinput.h>
#include <libudev.h>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <map>
#include <utility>

namespace franken::platform {

namespace {

int openDevice(const char* path, int flags, void* options) {
    const int descriptor = open(path, flags | O_CLOEXEC);
    if (descriptor >= 0 && static_cast<const InputOptions*>(options)->grab)
        ioctl(descriptor, EVIOCGRAB, 1);
    return descriptor < 0 ? -errno : descriptor;
}

void closeDevice(int descriptor, void*) { close(descriptor); }

constexpr libinput_interface kInterface = {openDevice, closeDevice};

std::chrono::microseconds microseconds(std::uint64_t time) {
    return std::chrono::microseconds(static_cast<std::int64_t>(time));
}

} // namespace

struct Input::State {
    InputOptions options;
    Owned<udev, udev_unref> devices{udev_new()};
    Owned<libinput, libinput_unref> context;
    /// Fingers that are down: their device, its slot, and where they were last.
    std::map<std::pair<libinput_device*, int>, std::pair<int, Point>> fingers;
    std::vector<InputEvent> events;

    void plugged(libinput_device* device, bool isPlugged);
    void touched(libinput_event* event);
    void endTouch(std::pair<libinput_device*, int> finger, TouchEvent::Kind kind,
                  std::chrono::microseconds time);
    void keyed(libinput_event* event);
    void pointed(libinput_event* event);
    void take(libinput_event* event);
    void takeAll();
    int freeFinger() const;
    Rotation touchRotation() const { return options.touch.value_or(options.screen); }
};

int Input::State::freeFinger() const {
    for (int number = 0;; ++number) {
        bool taken = false;
        for (const auto& [finger, down] : fingers)
            taken = taken || down.first == number;
        if (!taken)
            return number;
    }
}

void Input::State::endTouch(std::pair<libinput_device*, int> finger, TouchEvent::Kind kind,
                            std::chrono::microseconds time) {
    if (const auto down = fingers.find(finger); down != fingers.end()) {
        events.push_back(TouchEvent{kind, down->second.first, down->second.second, time});
        fingers.erase(down);
    }
}

void Input::State::touched(libinput_event* event) {
    libinput_event_touch* touch = libinput_event_get_touch_event(event);
    const std::pair finger(libinput_event_get_device(event), libinput_event_touch_get_seat_slot(touch));
    const std::chrono::microseconds time = microseconds(libinput_event_touch_get_time_usec(touch));
    const libinput_event_type type = libinput_event_get_type(event);
    if (type == LIBINPUT_EVENT_TOUCH_UP)
        return endTouch(finger, TouchEvent::Kind::Up, time);
    if (type == LIBINPUT_EVENT_TOUCH_CANCEL)
        return endTouch(finger, TouchEvent::Kind::Cancel, time);
    const Point sensor{libinput_event_touch_get_x_transformed(touch, 1),
                       libinput_event_touch_get_y_transformed(touch, 1)};
    const Point position = toViewer(sensor, touchRotation());
    const auto [down, isNew] = fingers.try_emplace(finger, freeFinger(), position);
    down->second.second = position;
    events.push_back(TouchEvent{isNew ? TouchEvent::Kind::Down : TouchEvent::Kind::Move, down->second.first,
                                position, time});
}

void Input::State::keyed(libinput_event* event) {
    libinput_event_keyboard* key = libinput_event_get_keyboard_event(event);
    events.push_back(KeyEvent{libinput_event_keyboard_get_key(key),
                              libinput_event_keyboard_get_key_state(key) == LIBINPUT_KEY_STATE_PRESSED,
                              microseconds(libinput_event_keyboard_get_time_usec(key))});
}

void Input::State::pointed(libinput_event* event) {
    libinput_event_pointer* pointer = libinput_event_get_pointer_event(event);
    PointerEvent ours = {.time = microseconds(libinput_event_pointer_get_time_usec(pointer))};
    if (libinput_event_get_type(event) == LIBINPUT_EVENT_POINTER_BUTTON) {
        ours.button = libinput_event_pointer_get_button(pointer);
        ours.down = libinput_event_pointer_get_button_state(pointer) == LIBINPUT_BUTTON_STATE_PRESSED;
    } else {
        ours.moved = {libinput_event_pointer_get_dx(pointer), libinput_event_pointer_get_dy(pointer)};
    }
    events.push_back(ours);
}

void Input::State::plugged(libinput_device* device, bool isPlugged) {
    const auto can = [&](libinput_device_capability capability) {
        return libinput_device_has_capability(device, capability) != 0;
    };
    const DeviceEvent event{libinput_device_get_name(device), isPlugged, can(LIBINPUT_DEVICE_CAP_TOUCH),
                            can(LIBINPUT_DEVICE_CAP_KEYBOARD), can(LIBINPUT_DEVICE_CAP_POINTER)};
    if (isPlugged && event.touch && options.touch && libinput_device_config_calibration_has_matrix(device)) {
        constexpr float kIdentity[6] = {1, 0, 0, 0, 1, 0};
        libinput_device_config_calibration_set_matrix(device, kIdentity);
    }
    if (!isPlugged)
        for (auto finger = fingers.begin(); finger != fingers.end();) {
            const auto next = std::next(finger);
            if (finger->first.first == device)
                endTouch(finger->first, TouchEvent::Kind::Cancel, {});
            finger = next;
        }
    if (options.log)
        options.log(LogLevel::Info, event.name + (isPlugged ? ": plugged" : ": unplugged"));
    events.push_back(event);
}

void Input::State::take(libinput_event* event) {
    switch (libinput_event_get_type(event)) {
    case LIBINPUT_EVENT_DEVICE_ADDED:
        return plugged(libinput_event_get_device(event), true);
    case LIBINPUT_EVENT_DEVICE_REMOVED:
        return plugged(libinput_event_get_device(event), false);
    case LIBINPUT_EVENT_TOUCH_DOWN:
    case LIBINPUT_EVENT_TOUCH_MOTION:
    case LIBINPUT_EVENT_TOUCH_UP:
    case LIBINPUT_EVENT_TOUCH_CANCEL:
        return touched(event);
    case LIBINPUT_EVENT_KEYBOARD_KEY:
        return keyed(event);
    case LIBINPUT_EVENT_POINTER_MOTION:
    case LIBINPUT_EVENT_POINTER_BUTTON:
        return pointed(event);
    default:
        return; // Frames, gestures, tablets: nothing that a kiosk asks for.
    }
}

void Input::State::takeAll() {
    while (libinput_event* event = libinput_get_event(context.get())) {
        take(event);
        libinput_event_destroy(event);
    }
}

Input::Input(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Input::~Input() = default;

Result<std::unique_ptr<Input>> Input::open(const InputOptions& options) {
    auto state = std::make_unique<State>();
    state->options = options;
    if (state->devices)
        state->context.reset(
            libinput_udev_create_context(&kInterface, &state->options, state->devices.get()));
    if (!state->context || libinput_udev_assign_seat(state->context.get(), options.seat.c_str()) != 0)
        return Error{"input.driver", options.seat, "the seat's devices cannot be opened",
                     "check that systemd-udevd runs"};
    state->takeAll(); // Devices are set up before their first touch is read.
    return std::unique_ptr<Input>(new Input(std::move(state)));
}

int Input::descriptor() const { return libinput_get_fd(m_state->context.get()); }

std::vector<InputEvent> Input::dispatch() {
    libinput_dispatch(m_state->context.get());
    m_state->takeAll();
    return std::exchange(m_state->events, {});
}

void Input::setScreenRotation(Rotation rotation) { m_state->options.screen = rotation; }

} // namespace franken::platform

#else

namespace franken::platform {

struct Input::State {};

Input::Input(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Input::~Input() = default;

Result<std::unique_ptr<Input>> Input::open(const InputOptions&) {
    return Error{"input.not-built", "", "the library was built without libinput",
                 "build it where libinput-dev and libudev-dev are installed"};
}

int Input::descriptor() const { return -1; }
std::vector<InputEvent> Input::dispatch() { return {}; }
void Input::setScreenRotation(Rotation) {}

} // namespace franken::platform

#endif
