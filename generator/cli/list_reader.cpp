// SPDX-License-Identifier: MIT
#include "list_reader.h"

#include <utility>

namespace franken::cli {

bool ListReader::key(string_t& name) {
    if (m_depth == kInDocument)
        m_listing = name == m_list;
    m_key = name;
    return true;
}

bool ListReader::start_array(std::size_t) {
    if (!scalar())
        return false;
    m_listed = m_listed || (m_listing && m_depth == kInDocument);
    return enter();
}

bool ListReader::refuse(std::string why) {
    m_wrong = std::move(why);
    return false;
}

bool ListReader::enter() {
    return ++m_depth <= m_maxDepth ||
           refuse("it nests deeper than a list of " + std::string(m_objects) + " does");
}

bool ListReader::leave() {
    --m_depth;
    m_listing = m_listing && m_depth > kInDocument;
    return true;
}

bool ListReader::scalar() {
    return !m_listing || m_depth != kInList || refuse("it lists what is no program");
}

} // namespace franken::cli
