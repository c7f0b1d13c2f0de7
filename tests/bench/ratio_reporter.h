// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <initializer_list>
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
                const bool isManual = run.run_name.time_type == "manual_time";
                const double time = isManual ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
                const auto [known, added] = m_times.emplace(run.run_name.function_name, time);
                if (!added)
                    known->second = std::min(known->second, time);
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

struct Ratio {
    const char* one;
    const char* other;
};

/// Runs the registered benchmarks and prints ratios of them. `sameResult` says that they do the same: where
/// they do not, nothing is measured. The exit code of the program.
inline int runWithRatios(int argc, char** argv, bool sameResult, std::initializer_list<Ratio> ratios) {
    benchmark::Initialize(&argc, argv);
    if (!sameResult) {
        std::fprintf(stderr, "the results differ: the comparison means nothing\n");
        return 1;
    }
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    for (const auto& [one, other] : ratios)
        reporter.printRatio(one, other);
    return 0;
}

} // namespace franken::bench
