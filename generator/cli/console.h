// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace franken::cli {

enum class Style { Plain, Bold, Dim, Red, Green, Cyan };

/// Standard output for data, standard error for messages. Data is coloured on a terminal only, and never
/// where NO_COLOR is set (no-color.org). What messages quote from outside cannot steer a terminal: see
/// franken/printable.h.
class Console {
public:
    Console();

    void write(std::string_view data);
    /// Text that others wrote, of one line: as it is, but on a terminal as printable() has it.
    std::string foreign(std::string_view text) const;
    std::string paint(Style style, std::string_view text) const;

    void note(std::string_view message) const;
    void error(const Error& error);

    /// From now on, errors are also answered with a JSON document: by main(), where there is nothing else.
    void answerInJson() { m_json = true; }
    bool answersInJson() const { return m_json; }
    const std::vector<Error>& errors() const { return m_errors; }
    void dropped(std::string_view name, const std::vector<Dropped>& dropped) const;

    /// One line on a terminal's standard error, overwritten by the next, at most ten a second, and none
    /// for work that is done in half a second. A total of 0 is an unknown one.
    void progress(std::string_view what, std::size_t done, std::size_t total);
    void endProgress();

    /// Whether all data reached standard output.
    bool flush();

    /// More errors than this are counted, not shown: a wrong file has one in each line.
    static constexpr std::size_t kMaxErrors = 20;
    void endErrors() const;

private:
    using Clock = std::chrono::steady_clock;

    bool m_terminal;
    bool m_json = false;
    bool m_color;
    bool m_progress;
    std::vector<Error> m_errors;
    std::size_t m_errorsLeftOut = 0;
    bool m_progressShown = false;
    Clock::time_point m_nextProgress;
};

} // namespace franken::cli
