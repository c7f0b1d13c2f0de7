// SPDX-License-Identifier: MIT
#include "device.h"

namespace franken::platform {

const KmsProperty* KmsObject::find(const std::string& name) const {
    const auto found = properties.find(name);
    return found == properties.end() ? nullptr : &found->second;
}

std::uint64_t KmsObject::value(const std::string& name) const {
    const KmsProperty* property = find(name);
    return property == nullptr ? 0 : property->value;
}

std::string KmsObject::word(const std::string& name) const {
    if (const KmsProperty* property = find(name))
        for (const auto& [word, value] : property->choices)
            if (value == property->value)
                return word;
    return {};
}

} // namespace franken::platform
