// SPDX-License-Identifier: MIT
#include "folder_manifest.h"

#include <nlohmann/json.hpp>

namespace franken::cli {
namespace {

using Json = nlohmann::json;

// The document, "programs", a program, its interface, a list of it, an entry, a list of that.
constexpr std::size_t kMaxDepth = 7;
constexpr std::size_t kMaxPrograms = 100'000, kMaxTextBytes = 4096;
constexpr std::size_t kInDocument = 1, kInPrograms = 2, kInProgram = 3;

class Reader : public nlohmann::json_sax<Json> {
public:
    Result<std::vector<ListedProgram>> read(std::string_view text) {
        const bool whole = Json::sax_parse(text, this);
        if (m_wrong.empty() && (!whole || !m_listed))
            m_wrong = "it lists no programs";
        if (!m_wrong.empty())
            return Error{"", "", m_wrong, ""};
        return std::move(m_programs);
    }

    bool null() override { return scalar(); }
    bool boolean(bool) override { return scalar(); }
    bool number_integer(number_integer_t) override { return scalar(); }
    bool number_unsigned(number_unsigned_t) override { return scalar(); }
    bool number_float(number_float_t, const string_t&) override { return scalar(); }
    bool binary(binary_t&) override { return scalar(); }
    bool string(string_t& text) override {
        if (!scalar())
            return false;
        if (!m_listing || m_depth != kInProgram)
            return true;
        if (text.size() > kMaxTextBytes)
            return refuse("it has a name that is longer than a path may be");
        keep(text);
        return true;
    }

    bool key(string_t& name) override {
        if (m_depth == kInDocument)
            m_listing = name == "programs";
        if (m_depth == kInProgram)
            m_key = name;
        return true;
    }

    bool start_object(std::size_t) override {
        if (!m_listing || m_depth != kInPrograms)
            return enter();
        if (m_programs.size() == kMaxPrograms)
            return refuse("it lists more programs than a folder has");
        m_programs.emplace_back();
        return enter();
    }
    bool start_array(std::size_t) override {
        if (!scalar())
            return false;
        m_listed = m_listed || (m_listing && m_depth == kInDocument);
        return enter();
    }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    bool refuse(const char* why) {
        m_wrong = why;
        return false;
    }
    bool enter() { return ++m_depth <= kMaxDepth || refuse("it nests deeper than a list of programs does"); }
    bool leave() {
        --m_depth;
        m_listing = m_listing && m_depth > kInDocument;
        return true;
    }

    // All but objects.
    bool scalar() { return !m_listing || m_depth != kInPrograms || refuse("it lists what is no program"); }

    void keep(const std::string& text) {
        ListedProgram& program = m_programs.back();
        if (m_key == "name")
            program.name = text;
        else if (m_key == "vertex")
            program.vertex = text;
        else if (m_key == "fragment")
            program.fragment = text;
    }

    std::vector<ListedProgram> m_programs;
    std::string m_key, m_wrong;
    std::size_t m_depth = 0;
    bool m_listing = false, m_listed = false;
};

} // namespace

Result<std::vector<ListedProgram>> parseFolderManifest(std::string_view text) { return Reader().read(text); }

} // namespace franken::cli
