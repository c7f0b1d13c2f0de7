// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/config/config.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace kiosk {

/// In the order of kActions.
enum class Action {
    Next,
    Previous,
    Pause,
    Lights,
    Brighter,
    Darker,
    NextCamera,
    Caption,
    Statistics,
    Screenshot,
    Wake
};
static_assert(kActions.size() == static_cast<std::size_t>(Action::Wake) + 1);

} // namespace kiosk
