// SPDX-License-Identifier: MIT
#include "kiosk/doctor/finding.h"

#include "franken/printable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace kiosk {

namespace {

constexpr std::array<const char*, 3> kWords = {"good", "note", "bad"};

const char* wordOf(Finding::Kind kind) { return kWords[static_cast<std::size_t>(kind)]; }

} // namespace

bool isHealthy(const Findings& findings) {
    return std::none_of(findings.begin(), findings.end(),
                        [](const Finding& finding) { return finding.kind == Finding::Kind::Bad; });
}

std::string toText(const Findings& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += std::string(wordOf(finding.kind)) + "  " + finding.topic + ": " +
                franken::printable(finding.what) + "\n";
        if (!finding.remedy.empty())
            text += "      -> " + franken::printable(finding.remedy) + "\n";
    }
    const auto bad = std::count_if(findings.begin(), findings.end(),
                                   [](const Finding& finding) { return finding.kind == Finding::Kind::Bad; });
    return text + (bad == 0 ? "Nothing is wrong.\n" : std::to_string(bad) + " to mend.\n");
}

std::string toJson(const Findings& findings) {
    nlohmann::json list = nlohmann::json::array();
    for (const Finding& finding : findings)
        list.push_back({{"kind", wordOf(finding.kind)},
                        {"topic", finding.topic},
                        {"what", finding.what},
                        {"remedy", finding.remedy}});
    const nlohmann::json all{{"healthy", isHealthy(findings)}, {"findings", list}};
    return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace kiosk
