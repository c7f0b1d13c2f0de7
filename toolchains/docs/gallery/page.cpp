// SPDX-License-Identifier: MIT
#include "page.h"

#include <fstream>
#include <optional>
#include <sstream>

namespace franken::gallery {
namespace {

constexpr std::string_view kHowTo = "run 'cmake --build <build tree> --target update-costs'";

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text)
        switch (c) {
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '&':
            result += "&amp;";
            break;
        case '@':
        case '\\':
        case '%':
            result += std::string("\\") + c;
            break;
        default:
            result += c;
        }
    return result;
}

/// "147", or "+5" over another number.
std::string figure(int value, const int* over) {
    if (over == nullptr)
        return std::to_string(value);
    const int more = value - *over;
    return more > 0 ? "+" + std::to_string(more) : more < 0 ? "−" + std::to_string(-more) : "0";
}

/// Of the first option in full; of the others, what they cost more.
std::string cell(const GpuPrice& price, const GpuPrice* first) {
    std::string text = figure(price.fragment, first == nullptr ? nullptr : &first->fragment);
    if (first == nullptr || price.vertex != first->vertex)
        text += " (" + figure(price.vertex, first == nullptr ? nullptr : &first->vertex) + ")";
    if (first == nullptr || price.threads != first->threads)
        text += "<br>" + std::to_string(price.threads) + (price.threads == 1 ? " thread" : " threads");
    return text;
}

std::string card(const Option& option, const Prices& prices, const Prices* first) {
    std::string text = "<div class=\"card\"><img src=\"" + pictureName(option) + "\" alt=\"" +
                       escaped(option.meaning) + "\"/><div class=\"word\"><code>" + escaped(option.word) +
                       "</code></div><div>" + escaped(option.meaning) + "</div><div class=\"prices\">";
    constexpr const char* kModels[] = {"Pi 0–3", "Pi 4", "Pi 5"};
    for (std::size_t gpu = 0; gpu < prices.size(); ++gpu)
        text += std::string("<span><b>") + kModels[gpu] + "</b><br>" +
                cell(prices[gpu], first == nullptr ? nullptr : &(*first)[gpu]) + "</span>";
    return text + "</div></div>\n";
}

Result<Prices> priceOf(const Option& option, const Permutation& program, const PriceTable& table) {
    const auto found = table.find({std::string(option.word), toName(program)});
    if (found == table.end())
        return Error{"gallery.prices", std::string(option.word),
                     "option_prices.tsv has no price of it in " + toName(program), std::string(kHowTo)};
    return found->second;
}

Result<std::string> section(const ChoiceProgram& row, const PriceTable& table) {
    const Choice& choice = *row.choice;
    const std::string name(choice.name);
    std::string text = "\n## " + name + " {#gallery_" + name + "}\n\n`" + toName(row.programs[0]) +
                       "`\n\n<div class=\"gallery\">\n";
    std::optional<Prices> first;
    for (std::size_t i = 0; i < choice.options.size(); ++i) {
        const Result<Prices> prices = priceOf(choice.options[i], row.programs[i], table);
        if (!prices)
            return prices.error();
        text += card(choice.options[i], *prices, first ? &*first : nullptr);
        if (!first)
            first = *prices;
    }
    return text + "</div>\n";
}

} // namespace

Result<PriceTable> readPrices(const std::filesystem::path& file) {
    std::ifstream in(file);
    PriceTable table;
    std::string line;
    std::getline(in, line); // The names of the columns.
    while (std::getline(in, line)) {
        std::istringstream columns(line);
        std::string word, name;
        Prices prices;
        std::getline(columns, word, '\t');
        std::getline(columns, name, '\t');
        for (GpuPrice& price : prices)
            columns >> price.fragment >> price.threads >> price.vertex;
        if (!columns)
            return Error{"gallery.prices", file.string(), "'" + line + "' is no row of it",
                         std::string(kHowTo)};
        table.emplace(std::pair(word, name), prices);
    }
    if (table.empty())
        return Error{"gallery.prices", file.string(), "it is not there, or empty", std::string(kHowTo)};
    return table;
}

std::string pictureName(const Option& option) { return "gallery-" + std::string(option.word) + ".png"; }

Result<std::string> pageOf(const std::vector<ChoiceProgram>& choices, const PriceTable& prices) {
    std::string text;
    for (const ChoiceProgram& row : choices) {
        const Result<std::string> next = section(row, prices);
        if (!next)
            return next.error();
        text += *next;
    }
    return text;
}

} // namespace franken::gallery
