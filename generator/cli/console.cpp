// SPDX-License-Identifier: MIT
#include "console.h"

#include "franken/printable.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace franken::cli {
namespace {

using namespace std::chrono_literals;

bool wantsColor() {
    const char* noColor = std::getenv("NO_COLOR");
    const char* term = std::getenv("TERM");
    const bool refused = noColor && *noColor != '\0';
    const bool dumb = !term || std::string_view(term) == "dumb";
    return !refused && !dumb;
}

std::string_view codeOf(Style style) {
    switch (style) {
    case Style::Bold:
        return "1";
    case Style::Dim:
        return "2";
    case Style::Red:
        return "31";
    case Style::Green:
        return "32";
    case Style::Cyan:
        return "36";
    case Style::Plain:
        break;
    }
    return {};
}

} // namespace

Console::Console()
    : m_terminal(isatty(STDOUT_FILENO)),
      m_color(m_terminal && wantsColor()),
      m_progress(isatty(STDERR_FILENO)),
      m_nextProgress(Clock::now() + 500ms) {}

void Console::write(std::string_view data) { std::cout << data; }

std::string Console::foreign(std::string_view text) const {
    return m_terminal ? printable(text) : std::string(text);
}

std::string Console::paint(Style style, std::string_view text) const {
    const std::string_view code = codeOf(style);
    if (!m_color || code.empty() || text.empty())
        return std::string(text);
    return "\033[" + std::string(code) + "m" + std::string(text) + "\033[0m";
}

void Console::note(std::string_view message) const {
    std::cerr << "frankenshader: " << printable(message) << '\n';
}

void Console::error(const Error& error) {
    endProgress();
    if (m_errors.size() == kMaxErrors) {
        ++m_errorsLeftOut;
        return;
    }
    m_errors.push_back(error);
    std::cerr << "frankenshader: error: " << printable(error) << '\n';
}

void Console::endErrors() const {
    if (m_errorsLeftOut > 0)
        note("and " + std::to_string(m_errorsLeftOut) + " more errors");
}

void Console::dropped(std::string_view name, const std::vector<Dropped>& dropped) const {
    for (const Dropped& each : dropped)
        note(std::string(name) + ": '" + each.word + "' is dropped: " + each.reason);
}

void Console::progress(std::string_view what, std::size_t done, std::size_t total) {
    if (!m_progress || Clock::now() < m_nextProgress)
        return;
    m_nextProgress = Clock::now() + 100ms;
    m_progressShown = true;
    std::cerr << "\r\033[K" << what << ' ' << done;
    if (total > 0)
        std::cerr << " of " << total;
    std::cerr << std::flush;
}

void Console::endProgress() {
    if (m_progressShown)
        std::cerr << "\r\033[K" << std::flush;
    m_progressShown = false;
}

bool Console::flush() { return static_cast<bool>(std::cout.flush()); }

} // namespace franken::cli
