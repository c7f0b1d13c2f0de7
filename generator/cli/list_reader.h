// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace franken::cli {

/// Reads the objects of one list in a JSON document, event by event, so that the document's size takes no
/// memory: {"LIST": [{…}, …], …}. Refuses a list of anything but objects, and deeper nesting than is
/// expected.
class ListReader : public nlohmann::json_sax<nlohmann::json> {
public:
    bool null() override { return scalar(); }
    bool boolean(bool) override { return scalar(); }
    bool number_integer(number_integer_t) override { return scalar(); }
    bool number_unsigned(number_unsigned_t) override { return scalar(); }
    bool number_float(number_float_t, const string_t&) override { return scalar(); }
    bool binary(binary_t&) override { return scalar(); }
    bool key(string_t& name) override;
    bool start_array(std::size_t) override;
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

protected:
    /// Depths: the document's own members, the list, an object of it.
    static constexpr std::size_t kInDocument = 1, kInList = 2, kInObject = 3;

    /// `objects`: what the list is of, for messages: "programs".
    ListReader(std::string_view list, std::string_view objects, std::size_t maxDepth)
        : m_list(list), m_objects(objects), m_maxDepth(maxDepth) {}

    bool refuse(std::string why);
    bool enter();
    bool leave();
    /// All but objects.
    bool scalar();

    bool isListing() const { return m_listing; }
    bool wasListed() const { return m_listed; }
    std::size_t depth() const { return m_depth; }
    const std::string& lastKey() const { return m_key; }
    const std::string& wrong() const { return m_wrong; } ///< Empty where nothing was refused.

private:
    std::string_view m_list, m_objects;
    std::size_t m_maxDepth, m_depth = 0;
    std::string m_key, m_wrong;
    bool m_listing = false, m_listed = false;
};

} // namespace franken::cli
