// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace kiosk {

/// What `kiosk doctor` has to say of one thing.
struct Finding {
    enum class Kind {
        Good,
        Note, ///< Worth knowing; nothing has to be done.
        Bad
    };
    Kind kind = Kind::Good;
    std::string topic;  ///< "screen", "memory", ...
    std::string what;   ///< One sentence.
    std::string remedy; ///< The command that mends it, or what to do; of Bad ones always.
};

using Findings = std::vector<Finding>;

bool isHealthy(const Findings& findings);
std::string toText(const Findings& findings);
std::string toJson(const Findings& findings);

} // namespace kiosk
