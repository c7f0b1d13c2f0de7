// SPDX-License-Identifier: MIT
#include "cost_baseline.h"

#include "franken/file.h"
#include "list_reader.h"

#include <algorithm>

namespace franken::cli {
namespace {

// The document, "costs", a program, "atMost", one of its models.
constexpr std::size_t kMaxDepth = 5;
constexpr std::size_t kInShader = 4;
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

class Reader : public ListReader {
public:
    Reader() : ListReader("costs", "costs", kMaxDepth) {}

    Result<CostBaseline> read(std::string_view text) {
        const bool whole = nlohmann::json::sax_parse(text, this);
        if (wrong().empty() && (!whole || !m_isCosts || !wasListed()))
            refuse("it is not what 'frankenshader cost --json' wrote");
        if (!wrong().empty())
            return Error{"", "", wrong(), ""};
        return std::move(m_costs);
    }

    bool number_integer(number_integer_t) override { return scalar() && !figure(); }
    bool number_float(number_float_t, const string_t&) override { return scalar() && !figure(); }
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
        if (depth() == kInDocument && lastKey() == "command")
            m_isCosts = text == "cost";
        if (isListing() && depth() == kInObject)
            keep(text);
        return true;
    }

    bool start_object(std::size_t) override {
        if (isListing() && depth() == kInList) {
            m_name.clear();
            m_gpu.clear();
            m_cost = {};
        }
        m_shader = depth() == kInObject ? memberOf(kShaders, lastKey()) : nullptr;
        return enter();
    }
    bool start_array(std::size_t size) override {
        m_shader = nullptr;
        return ListReader::start_array(size);
    }
    bool end_object() override {
        leave();
        if (!isListing() || depth() != kInList)
            return true;
        if (m_name.empty() || m_gpu.empty())
            return refuse("it lists a program without its name or GPU");
        m_costs[{m_name, m_gpu}] = m_cost;
        return true;
    }

private:
    /// Where the next number belongs; null where none is kept.
    int* figure() {
        if (!isListing() || depth() != kInShader || m_shader == nullptr)
            return nullptr;
        const auto member = memberOf(kFigures, lastKey());
        return member == nullptr ? nullptr : &(m_cost.*m_shader.*member);
    }

    void keep(const std::string& text) {
        if (lastKey() == "name")
            m_name = text;
        else if (lastKey() == "gpu")
            m_gpu = text;
        else if (lastKey() == "error")
            m_cost.error = text;
    }

    CostBaseline m_costs;
    std::string m_name, m_gpu;
    Cost m_cost;
    ShaderCost Cost::*m_shader = nullptr;
    bool m_isCosts = false;
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
