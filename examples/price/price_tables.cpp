// SPDX-License-Identifier: MIT
#include "price_tables.h"

#include "feature_lines.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <sstream>

using namespace franken;

namespace price {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> cellsOf(const std::string& line, char separator) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, separator);) {
        const std::size_t begin = cell.find_first_not_of(' '), end = cell.find_last_not_of(' ');
        cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
    }
    return cells;
}

/// "+5", "−3" (a minus sign), "0".
int numberOf(std::string text) {
    const std::string minus = "\u2212";
    if (const std::size_t at = text.find(minus); at != std::string::npos)
        text.replace(at, minus.size(), "-");
    return std::atoi(text.c_str()); // NOLINT(cert-err34-c): of our own table, which a test reads.
}

/// Programs that are too different for the price list to bridge.
bool isOfAKind(const Permutation& a, const Permutation& b) {
    return a.program == b.program && a.shading == b.shading && a.view == b.view && a.precision == b.precision;
}

using Features = std::map<std::string, int>;

/// What the first has more, by feature; negative where it has less.
Features difference(Features features, const Features& without) {
    for (const auto& [line, times] : without)
        features[line] -= times;
    std::erase_if(features, [](const auto& feature) { return feature.second == 0; });
    return features;
}

int size(const Features& features) {
    int sum = 0;
    for (const auto& [line, times] : features)
        sum += std::abs(times);
    return sum;
}

} // namespace

PriceTables::PriceTables(std::string_view costs, std::string_view prices) {
    for (const std::string& line : linesOf(costs)) {
        const std::vector<std::string> cells = cellsOf(line, '\t');
        const Result<Permutation> program = cells.size() < 11 ? Error{} : parseName(cells[1]);
        if (program && cells[2] == "ok")
            m_rows.push_back({cells[0],
                              *program,
                              {.fragment = numberOf(cells[3]),
                               .vertex = numberOf(cells[9]),
                               .coordinate = numberOf(cells[10]),
                               .threads = numberOf(cells[4]),
                               .known = Known::Table}});
    }
    constexpr std::array kColumns = {"vc4", "v3d42", "v3d71"};
    for (const std::string& line : linesOf(prices)) {
        const std::vector<std::string> cells = cellsOf(line, '|');
        for (std::size_t i = 0; i < kColumns.size() && cells.size() > i + 2; ++i) {
            const std::string& cell = cells[i + 2];
            const std::size_t vertex = cell.find('(');
            m_prices[kColumns[i]][cells[1]] = {
                numberOf(cell), vertex == std::string::npos ? 0 : numberOf(cell.substr(vertex + 1))};
        }
    }
}

ProgramCost PriceTables::of(std::string_view gpu, const Permutation& program) const {
    const Features features = featuresOf(program);
    const Row* nearest = nullptr;
    int least = std::numeric_limits<int>::max();
    for (const Row& row : m_rows) {
        if (row.gpu != gpu)
            continue;
        if (row.program == program)
            return row.cost;
        const int distance = size(difference(features, featuresOf(row.program)));
        if (isOfAKind(row.program, program) && distance < least) {
            least = distance;
            nearest = &row;
        }
    }
    if (nearest == nullptr)
        return {.error = "neither the table nor the price list has such a program"};
    ProgramCost cost = nearest->cost;
    cost.known = Known::Interpolated;
    cost.threads = 0;
    const auto prices = m_prices.find(gpu);
    for (const auto& [line, times] : difference(features, featuresOf(nearest->program)))
        if (prices != m_prices.end())
            if (const auto found = prices->second.find(line); found != prices->second.end()) {
                cost.fragment += times * found->second.fragment;
                cost.vertex += times * found->second.vertex;
            }
    cost.fragment = std::max(cost.fragment, 1);
    cost.vertex = std::max(cost.vertex, 1);
    return cost;
}

} // namespace price
