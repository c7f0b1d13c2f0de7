// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/budget.h"
#include "franken/generator/explain.h"
#include "program.h"

namespace franken::cli {

/// One line of a program and where it comes from.
struct ExplainedLine {
    std::string_view text;
    LineOrigin origin;
    const Reason* reason; ///< Null for a line that no snippet wrote.
};

/// A resource that exceeds a profile, and the choices that could be given up.
struct Excess {
    Use use;
    std::vector<Feature> features;
};

struct ProfileBudget {
    Profile profile;
    Budget budget;
    std::vector<Excess> excesses;
};

ProfileBudget budgetFor(const Program& program, const Profile& profile);

/// "without 'normal' it takes 6, without 'vertexcolor' 7": what could be given up, the most relieving first.
std::string adviceFor(const Excess& excess);

/// All that `frankenshader explain` tells.
struct Explanation {
    explicit Explanation(Program explained, std::vector<Dropped> noOps);
    Explanation(const Explanation&) = delete;
    Explanation& operator=(const Explanation&) = delete;

    Program program;
    std::vector<Dropped> dropped;
    std::vector<Reason> reasons;
    std::vector<ExplainedLine> vertex, fragment;
    std::vector<ProfileBudget> budgets;
};

} // namespace franken::cli
