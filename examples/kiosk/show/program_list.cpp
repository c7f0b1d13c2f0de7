// SPDX-License-Identifier: MIT
#include "kiosk/show/program_list.h"

#include <algorithm>

namespace kiosk {

using franken::ProgramUse;

ProgramList::~ProgramList() {
    m_task.wait();
    write();
}

std::vector<ProgramUse> ProgramList::read() const {
    std::error_code error;
    if (m_file.empty() || !std::filesystem::exists(m_file, error))
        return {};
    return franken::readManifestOrNothing(m_file, m_log);
}

void ProgramList::add(const ProgramUse& use) {
    const std::lock_guard lock(m_mutex);
    if (std::find(m_unwritten.begin(), m_unwritten.end(), use) == m_unwritten.end())
        m_unwritten.push_back(use);
}

void ProgramList::keep() {
    if (!m_task.runs())
        m_task.start([this] { write(); });
}

void ProgramList::write() {
    std::unique_lock lock(m_mutex);
    const std::vector<ProgramUse> uses = m_unwritten;
    lock.unlock();
    if (m_file.empty() || uses.empty())
        return;
    const franken::Result<void> kept = franken::appendToManifest(m_file, uses);
    m_keeping.note(kept, m_log);
    lock.lock();
    if (kept)
        m_unwritten.erase(m_unwritten.begin(),
                          m_unwritten.begin() + static_cast<std::ptrdiff_t>(uses.size()));
}

} // namespace kiosk
