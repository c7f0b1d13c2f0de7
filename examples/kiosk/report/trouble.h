// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/result.h"

#include <string>
#include <utility>

namespace kiosk {

/// Something that is done again and again and may fail each time: the log hears once that it fails, and once
/// that it works again.
class Trouble {
public:
    /// What the log says: "the picture is not drawn", "the picture is drawn again".
    Trouble(std::string fails, std::string works) : m_fails(std::move(fails)), m_works(std::move(works)) {}

    void note(const franken::Result<void>& done, const franken::Log& log) {
        if (std::exchange(m_isFailing, !done) == !done)
            return;
        if (done)
            log(franken::LogLevel::Info, m_works);
        else
            log(franken::LogLevel::Error, m_fails + ": " + franken::toString(done.error()));
    }

private:
    std::string m_fails, m_works;
    bool m_isFailing = false;
};

} // namespace kiosk
