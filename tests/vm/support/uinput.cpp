// SPDX-License-Identifier: MIT
#include "support/uinput.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <linux/uinput.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace franken::test {

namespace {

void settleUdev() { EXPECT_EQ(std::system("udevadm settle --timeout=20"), 0); }

} // namespace

UinputDevice::UinputDevice(Kind kind, const std::string& name)
    : m_device(open("/dev/uinput", O_WRONLY | O_NONBLOCK | O_CLOEXEC)) {
    declare(UI_SET_EVBIT, EV_KEY);
    if (kind == Kind::Keyboard) {
        for (unsigned key = KEY_ESC; key <= KEY_DOWN; ++key)
            declare(UI_SET_KEYBIT, key);
    } else {
        declare(UI_SET_EVBIT, EV_ABS);
        declare(UI_SET_KEYBIT, BTN_TOUCH);
        declare(UI_SET_PROPBIT, INPUT_PROP_DIRECT);
        for (const unsigned axis : {ABS_X, ABS_Y, ABS_MT_POSITION_X, ABS_MT_POSITION_Y})
            declareAxis(axis, kExtent);
        declareAxis(ABS_MT_SLOT, 1);
        declareAxis(ABS_MT_TRACKING_ID, 65535);
    }
    uinput_setup setup = {};
    setup.id = {BUS_USB, 1, static_cast<__u16>(kind == Kind::Keyboard ? 1 : 2), 1};
    std::snprintf(setup.name, sizeof setup.name, "%s", name.c_str());
    EXPECT_EQ(ioctl(m_device, UI_DEV_SETUP, &setup), 0);
    EXPECT_EQ(ioctl(m_device, UI_DEV_CREATE), 0);
    settleUdev();
}

UinputDevice::~UinputDevice() {
    ioctl(m_device, UI_DEV_DESTROY);
    close(m_device);
    settleUdev();
}

void UinputDevice::declare(unsigned long request, unsigned code) const {
    EXPECT_EQ(ioctl(m_device, request, code), 0) << code;
}

void UinputDevice::declareAxis(unsigned code, int maximum) const {
    declare(UI_SET_ABSBIT, code);
    uinput_abs_setup axis = {};
    axis.code = static_cast<__u16>(code);
    axis.absinfo.maximum = maximum;
    axis.absinfo.resolution = 10; // Units a millimetre: libinput distrusts a device that does not say.
    EXPECT_EQ(ioctl(m_device, UI_ABS_SETUP, &axis), 0);
}

void UinputDevice::send(unsigned type, unsigned code, int value) const {
    input_event event = {};
    event.type = static_cast<__u16>(type);
    event.code = static_cast<__u16>(code);
    event.value = value;
    EXPECT_EQ(write(m_device, &event, sizeof event), static_cast<ssize_t>(sizeof event));
}

void UinputDevice::key(unsigned key, bool down) const {
    send(EV_KEY, key, down ? 1 : 0);
    send(EV_SYN, SYN_REPORT, 0);
}

void UinputDevice::touch(int slot, int x, int y, bool isNew) const {
    send(EV_ABS, ABS_MT_SLOT, slot);
    if (isNew) {
        send(EV_ABS, ABS_MT_TRACKING_ID, 100 + slot);
        send(EV_KEY, BTN_TOUCH, 1);
    }
    send(EV_ABS, ABS_MT_POSITION_X, x);
    send(EV_ABS, ABS_MT_POSITION_Y, y);
    send(EV_SYN, SYN_REPORT, 0);
}

void UinputDevice::release(int slot) const {
    send(EV_ABS, ABS_MT_SLOT, slot);
    send(EV_ABS, ABS_MT_TRACKING_ID, -1);
    send(EV_KEY, BTN_TOUCH, 0);
    send(EV_SYN, SYN_REPORT, 0);
}

std::string UinputDevice::node() const {
    char name[64] = "";
    EXPECT_GE(ioctl(m_device, UI_GET_SYSNAME(sizeof name), name), 0);
    for (const auto& entry :
         std::filesystem::directory_iterator("/sys/devices/virtual/input/" + std::string(name)))
        if (const std::string event = entry.path().filename(); event.starts_with("event"))
            return "/dev/input/" + event;
    return {};
}

} // namespace franken::test
