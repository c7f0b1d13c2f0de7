// SPDX-License-Identifier: MIT
#include "dearer.h"

namespace franken::cli {
namespace {

bool rises(int before, int after) { return after > before * 1.03; }

} // namespace

std::string dearer(const Cost& before, const Cost& after) {
    if (!before.measured())
        return "";
    if (!after.measured())
        return "there were figures, and now: " + after.error;
    std::string text;
    const auto compare = [&](const char* what, int was, int is, bool isWorse) {
        if (isWorse)
            text += std::string(text.empty() ? "" : "; ") + what + " went from " + std::to_string(was) +
                    " to " + std::to_string(is);
    };
    const auto compareShader = [&](const char* what, const ShaderCost& was, const ShaderCost& is) {
        compare(what, was.instructions, is.instructions, rises(was.instructions, is.instructions));
    };
    compareShader("fragment instructions", before.fragment, after.fragment);
    compare("threads", before.fragment.threads, after.fragment.threads,
            after.fragment.threads < before.fragment.threads);
    compare("spills", before.fragment.spills, after.fragment.spills,
            after.fragment.spills > before.fragment.spills);
    compareShader("vertex instructions", before.vertex, after.vertex);
    compareShader("coordinate instructions", before.coordinate, after.coordinate);
    return text;
}

} // namespace franken::cli
