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

/// What the configuration has keys, buttons and gestures do.
class ActionTable {
public:
    ActionTable() = default;
    explicit ActionTable(const Config& config);

    std::optional<Action> ofKey(unsigned code) const;
    std::optional<Action> ofButton(const ButtonName& button) const;
    std::optional<Action> ofGesture(const std::string& gesture) const;

    /// The GPIO lines that have a button.
    std::set<unsigned> pins() const;
    /// Whether a double press of it means anything: only then does a single one have to wait.
    bool isDoubled(unsigned pin) const;

private:
    std::map<unsigned, Action> m_keys;
    std::vector<std::pair<ButtonName, Action>> m_buttons;
    std::map<std::string, Action> m_gestures;
};

} // namespace kiosk
