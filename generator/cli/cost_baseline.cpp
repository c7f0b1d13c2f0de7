// SPDX-License-Identifier: MIT
#include "cost_baseline.h"

#include "franken/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace franken::cli {
namespace {

using Json = nlohmann::json;

// The document, "costs", a program, "atMost", one of its models.
constexpr std::size_t kMaxDepth = 5;
constexpr std::size_t kInDocument = 1, kInCosts = 2, kInProgram = 3, kInShader = 4;
constexpr std::size_t kMaxBytes = std::size_t{64} << 20U, kMaxTextBytes = 4096;
constexpr std::uint64_t kMaxFigure = 1'000'000;

constexpr std::pair<std::string_view, ShaderCost Cost::*> kShaders[] = {
    {"fragment", &Cost::fragment}, {"vertex", &Cost::vertex}, {"coordinate", &Cost::coordinate}};
constexpr std::pair<std::string_view, int ShaderCost::*> kFigures[] = {
    {"instructions", &ShaderCost::instructions},
    {"threads", &ShaderCost::threads},
    {"uniforms", &ShaderCost::uniforms},
    {"temps", &ShaderCost::temps},
    {"spills", &ShaderCost::spills},
    {"fills", &ShaderCost::fills}};

/// The member of that name in one of the tables above, or null.
template<typename Table>
auto memberOf(const Table& table, std::string_view name) {
    const auto found =
        std::find_if(std::begin(table), std::end(table), [&](const auto& row) { return row.first == name; });
    return found == std::end(table) ? nullptr : found->second;
}

class Reader : public nlohmann::json_sax<Json> {
public:
    Result<CostBaseline> read(std::string_view text) {
        const bool whole = Json::sax_parse(text, this);
        if (m_wrong.empty() && (!whole || !m_isCosts || !m_listed))
            m_wrong = "it is not what 'frankenshader cost --json' wrote";
        if (!m_wrong.empty())
            return Error{"", "", m_wrong, ""};
        return std::move(m_costs);
    }

    bool null() override { return scalar(); }
    bool boolean(bool) override { return scalar(); }
    bool number_integer(number_integer_t) override { return scalar() && !figure(); }
    bool number_float(number_float_t, const string_t&) override { return scalar() && !figure(); }
    bool binary(binary_t&) override { return scalar(); }
    bool number_unsigned(number_unsigned_t number) override {
        if (!scalar())
            return false;
        if (int* const into = figure(); into != nullptr) {
            if (number > kMaxFigure)
                return refuse("it has a figure that no shader has");
            *into = static_cast<int>(number);
        }
        return true;
    }
    bool string(string_t& text) override {
        if (!scalar())
            return false;
        if (text.size() > kMaxTextBytes)
            return refuse("it has a name that is longer than any program's");
        if (m_depth == kInDocument && m_key == "command")
            m_isCosts = text == "cost";
        if (m_listing && m_depth == kInProgram)
            keep(text);
        return true;
    }

    bool key(string_t& name) override {
        if (m_depth == kInDocument)
            m_listing = name == "costs";
        m_key = name;
        return true;
    }

    bool start_object(std::size_t) override {
        if (m_listing && m_depth == kInCosts) {
            m_name.clear();
            m_gpu.clear();
            m_cost = {};
        }
        m_shader = m_depth == kInProgram ? memberOf(kShaders, m_key) : nullptr;
        return enter();
    }
    bool start_array(std::size_t) override {
        if (!scalar())
            return false;
        m_listed = m_listed || (m_listing && m_depth == kInDocument);
        m_shader = nullptr;
        return enter();
    }
    bool end_object() override {
        leave();
        if (!m_listing || m_depth != kInCosts)
            return true;
        if (m_name.empty() || m_gpu.empty())
            return refuse("it lists a program without its name or GPU");
        m_costs[{m_name, m_gpu}] = m_cost;
        return true;
    }
    bool end_array() override { return leave(); }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    bool refuse(const char* why) {
        m_wrong = why;
        return false;
    }
    bool enter() { return ++m_depth <= kMaxDepth || refuse("it nests deeper than a list of costs does"); }
    bool leave() {
        --m_depth;
        m_listing = m_listing && m_depth > kInDocument;
        return true;
    }

    // All but objects.
    bool scalar() { return !m_listing || m_depth != kInCosts || refuse("it lists what is no program"); }

    /// Where the next number belongs; null where none is kept.
    int* figure() {
        if (!m_listing || m_depth != kInShader || m_shader == nullptr)
            return nullptr;
        const auto member = memberOf(kFigures, m_key);
        return member == nullptr ? nullptr : &(m_cost.*m_shader.*member);
    }

    void keep(const std::string& text) {
        if (m_key == "name")
            m_name = text;
        else if (m_key == "gpu")
            m_gpu = text;
        else if (m_key == "error")
            m_cost.error = text;
    }

    CostBaseline m_costs;
    std::string m_name, m_gpu, m_key, m_wrong;
    Cost m_cost;
    ShaderCost Cost::*m_shader = nullptr;
    std::size_t m_depth = 0;
    bool m_listing = false, m_listed = false, m_isCosts = false;
};

Error refused(const std::string& file, const std::string& why) {
    return {"cost.baseline", file, why, "name a file that 'frankenshader cost --json' wrote"};
}

} // namespace

Result<CostBaseline> parseCostBaseline(std::string_view text) { return Reader().read(text); }

Result<CostBaseline> readCostBaseline(const std::string& file) {
    const Result<std::vector<std::uint8_t>> bytes = readFile(file, kMaxBytes);
    if (!bytes)
        return refused(file, bytes.error().what);
    Result<CostBaseline> baseline =
        parseCostBaseline({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    return baseline ? std::move(baseline) : refused(file, baseline.error().what);
}

} // namespace franken::cli
