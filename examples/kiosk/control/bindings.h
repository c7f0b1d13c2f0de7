// SPDX-License-Identifier: MIT
#pragma once

#include "kiosk/config/checks.h"
#include "kiosk/control/action.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kiosk {

/// The actions that the configuration gives to keys, buttons and gestures.
class ActionTable {
public:
    ActionTable() = default;
    explicit ActionTable(const Config& config);

    std::optional<Action> ofKey(unsigned code) const;
    std::optional<Action> ofButton(const ButtonName& button) const;
    std::optional<Action> ofGesture(const std::string& gesture) const;

    /// The GPIO lines that have a button.
    std::set<unsigned> pins() const;
    /// Whether a double press of the button has an action: only then does a single press wait for a second.
    bool isDoubled(unsigned pin) const;

private:
    std::map<unsigned, Action> m_keys;
    std::vector<std::pair<ButtonName, Action>> m_buttons;
    std::map<std::string, Action> m_gestures;
};

} // namespace kiosk
