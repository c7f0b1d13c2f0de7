// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/manifest.h"
#include "kiosk/report/background_task.h"
#include "kiosk/report/trouble.h"

#include <filesystem>
#include <mutex>
#include <vector>

namespace kiosk {

/// The programs that a kiosk has needed so far, kept in a file from start to start.
class ProgramList {
public:
    /// `file`: empty, nothing is kept.
    ProgramList(std::filesystem::path file, franken::Log log)
        : m_file(std::move(file)), m_log(std::move(log)) {}
    /// Waits until the file has what was added, or cannot be written.
    ~ProgramList();
    ProgramList(const ProgramList&) = delete;
    ProgramList& operator=(const ProgramList&) = delete;

    /// What earlier runs kept; the log says where that cannot be read.
    std::vector<franken::ProgramUse> read() const;

    /// Notes a program for the next keep().
    void add(const franken::ProgramUse& use);
    /// Writes what was added to the file, on a thread of its own. Where that fails, or where an earlier write
    /// is not done yet, it is written by the next call.
    void keep();

private:
    void write();

    std::filesystem::path m_file;
    franken::Log m_log;
    std::mutex m_mutex; ///< Of the next one.
    std::vector<franken::ProgramUse> m_unwritten;
    Trouble m_keeping{"the list of programs is not kept", "the list of programs is kept again"};
    BackgroundTask m_task; ///< Last: it uses all of the above.
};

} // namespace kiosk
