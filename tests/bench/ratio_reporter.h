// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

namespace franken::bench {

/// Prints as the console does, and keeps the times: of repetitions, the shortest, which others disturbed
/// least.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration) {
                const auto [known, added] =
                    m_times.emplace(run.run_name.function_name, run.GetAdjustedCPUTime());
                if (!added)
                    known->second = std::min(known->second, run.GetAdjustedCPUTime());
            }
        ConsoleReporter::ReportRuns(runs);
    }

    void printRatio(const std::string& one, const std::string& other) {
        if (m_times.count(one) != 0 && m_times.count(other) != 0)
            std::printf("%s / %s: %.4g\n", one.c_str(), other.c_str(), m_times[one] / m_times[other]);
    }

private:
    std::map<std::string, double> m_times;
};

} // namespace franken::bench
