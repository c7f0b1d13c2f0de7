// SPDX-License-Identifier: MIT
#include "commands.h"
#include "explanation.h"
#include "franken/generator/lint.h"
#include "glslang.h"
#include "json.h"
#include "selection.h"

#include <algorithm>

namespace franken::cli {
namespace {

void checkBudget(const Program& program, const Profile& profile, std::vector<Finding>& findings) {
    for (const Excess& excess : budgetFor(program, profile).excesses)
        findings.push_back({program.name, "budget", std::string(profile.name),
                            std::string(toText(excess.use.resource)) + ": " +
                                std::to_string(excess.use.used) + " of " + std::to_string(excess.use.limit),
                            adviceFor(excess)});
}

void checkUnits(const Program& program, const Profile& profile, std::vector<Finding>& findings) {
    std::string roles;
    for (const std::string_view role : budget(program.composed.interface, profile).rolesBeyond)
        roles.append(roles.empty() ? "" : ", ").append(role);
    if (!roles.empty())
        findings.push_back({program.name, "budget", std::string(profile.name),
                            "there is no texture unit for: " + roles, "leave the texture out"});
}

void checkLint(const Program& program, std::vector<Finding>& findings) {
    for (const LintFinding& finding : lintProgram(program.composed))
        findings.push_back({program.name, "lint", toString(finding.origin),
                            finding.message + " [" + std::string(finding.rule) + "]", ""});
}

// A batch of programs is one process of glslang's: starting it takes longer than what it does for a program.
constexpr std::size_t kBatch = 64;

Result<void> checkBatch(const std::vector<Program>& batch, const std::vector<Profile>& profiles,
                        const std::optional<Glslang>& glslang, std::vector<Finding>& findings) {
    std::vector<std::vector<Finding>> external(batch.size());
    if (glslang) {
        auto found = glslang->check(batch);
        if (!found)
            return found.error();
        external = *std::move(found);
    }
    for (std::size_t i = 0; i < batch.size(); ++i) {
        for (const Profile& profile : profiles) {
            checkBudget(batch[i], profile, findings);
            checkUnits(batch[i], profile, findings);
        }
        checkLint(batch[i], findings);
        findings.insert(findings.end(), external[i].begin(), external[i].end());
    }
    return {};
}

Result<std::vector<Finding>> checkAll(const std::vector<Permutation>& permutations,
                                      const std::vector<Profile>& profiles,
                                      const std::optional<Glslang>& glslang, Console& console) {
    std::vector<Finding> findings;
    for (std::size_t begin = 0; begin < permutations.size(); begin += kBatch) {
        console.progress("programs checked:", begin, permutations.size());
        const auto first = permutations.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::size_t count = std::min(kBatch, permutations.size() - begin);
        const std::vector<Program> batch(first, first + static_cast<std::ptrdiff_t>(count));
        if (const Result<void> done = checkBatch(batch, profiles, glslang, findings); !done)
            return done.error();
    }
    return findings;
}

} // namespace

ExitCode run(const CheckOptions& options, Console& console) {
    const auto permutations = select(options.selection, console);
    if (!permutations)
        return ExitCode::Refused;
    const auto glslang = Glslang::open();
    if (!glslang)
        return console.error(glslang.error()), ExitCode::Device;
    if (!*glslang)
        console.note("glslangValidator is not installed, so its check was skipped (Debian: glslang-tools)");
    const auto findings = checkAll(*permutations, profilesOf(options.selection.profiles), *glslang, console);
    console.endProgress();
    if (!findings)
        return console.error(findings.error()), ExitCode::Device;
    if (options.json)
        console.write(
            checkJson(permutations->size(), options.selection.profiles, glslang->has_value(), *findings));
    else
        for (const Finding& finding : *findings)
            console.write(toLine(finding));
    console.note(std::to_string(permutations->size()) + " programs checked, " +
                 std::to_string(findings->size()) + " findings");
    return findings->empty() ? ExitCode::Ok : ExitCode::Failed;
}

} // namespace franken::cli
