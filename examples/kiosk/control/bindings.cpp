// SPDX-License-Identifier: MIT
#include "kiosk/control/bindings.h"

#include <algorithm>

namespace kiosk {

namespace {

template<typename Key>
std::optional<Action> lookUp(const std::map<Key, Action>& table, const Key& key) {
    const auto found = table.find(key);
    return found == table.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

ActionTable::ActionTable(const Config& config) {
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        const std::string name(kActions[i]);
        const auto action = static_cast<Action>(i);
        for (const std::string& key : config.keys.at(name))
            m_keys[*keyCode(key)] = action;
        for (const std::string& button : config.buttons.at(name))
            m_buttons.emplace_back(*parseButton(button), action);
        for (const std::string& gesture : config.touch.at(name))
            m_gestures[gesture] = action;
    }
}

std::optional<Action> ActionTable::ofKey(unsigned code) const { return lookUp(m_keys, code); }

std::optional<Action> ActionTable::ofGesture(const std::string& gesture) const {
    return lookUp(m_gestures, gesture);
}

std::optional<Action> ActionTable::ofButton(const ButtonName& button) const {
    for (const auto& [name, action] : m_buttons)
        if (name == button)
            return action;
    return {};
}

std::set<unsigned> ActionTable::pins() const {
    std::set<unsigned> pins;
    for (const auto& entry : m_buttons)
        pins.insert(entry.first.pin);
    return pins;
}

bool ActionTable::isDoubled(unsigned pin) const {
    return std::any_of(m_buttons.begin(), m_buttons.end(), [pin](const auto& entry) {
        return entry.first.pin == pin && entry.first.press == PressKind::Double;
    });
}

} // namespace kiosk
