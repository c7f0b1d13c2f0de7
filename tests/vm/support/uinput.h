// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace franken::test {

/// A keyboard or a touch screen that is plugged in for as long as it lives: by the kernel's uinput. udevd is
/// waited for.
class UinputDevice {
public:
    enum class Kind { Keyboard, TouchScreen };
    /// Of a touch screen's coordinates: 0 to this, in both directions.
    static constexpr int kExtent = 1000;

    UinputDevice(Kind kind, const std::string& name);
    ~UinputDevice();
    UinputDevice(const UinputDevice&) = delete;
    UinputDevice& operator=(const UinputDevice&) = delete;

    void key(unsigned key, bool down) const;
    /// A finger of one of two slots: touches, moves or leaves.
    void touch(int slot, int x, int y, bool isNew) const;
    void release(int slot) const;
    /// "/dev/input/event0".
    std::string node() const;

private:
    void send(unsigned type, unsigned code, int value) const;
    void declare(unsigned long request, unsigned code) const;
    void declareAxis(unsigned code, int maximum) const;

    int m_device;
};

} // namespace franken::test
