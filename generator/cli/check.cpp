// SPDX-License-Identifier: MIT
#include "commands.h"
#include "explanation.h"
#include "franken/generator/lint.h"
#include "glslang.h"
#include "json.h"
#include "selection.h"

namespace franken::cli {
namespace {

std::vector<Profile> profilesFor(const std::vector<std::string>& names) {
    std::vector<Profile> wanted;
    for (const Profile& profile : profiles())
        for (const std::string& name : names)
            if (name == profile.name || name == "all")
                wanted.push_back(profile);
    return wanted;
}

void checkBudget(const Program& program, const Profile& profile, std::vector<Finding>& findings) {
    for (const Burst& burst : budgetFor(program, profile).bursts)
        findings.push_back({program.name, "budget", std::string(profile.name),
                            std::string(toText(burst.use.resource)) + ": " + std::to_string(burst.use.used) +
                                " of " + std::to_string(burst.use.limit),
                            adviceFor(burst)});
}

void checkLint(const Program& program, std::vector<Finding>& findings) {
    for (const LintFinding& finding : lintProgram(program.composed))
        findings.push_back({program.name, "lint", toString(finding.origin),
                            finding.message + " [" + std::string(finding.rule) + "]", ""});
}

std::string lineOf(const Finding& finding) {
    return (finding.where.empty() ? finding.program : finding.where) + ": " + finding.check + ": " +
           finding.what + (finding.remedy.empty() ? "" : " (" + finding.remedy + ")") +
           (finding.where.empty() ? "" : " in " + finding.program) + "\n";
}

Result<std::vector<Finding>> checkAll(const std::vector<Permutation>& permutations,
                                      const std::vector<Profile>& profiles,
                                      const std::optional<Glslang>& glslang, Console& console) {
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < permutations.size(); ++i) {
        console.progress("programs checked:", i, permutations.size());
        const Program program(permutations[i]);
        for (const Profile& profile : profiles)
            checkBudget(program, profile, findings);
        checkLint(program, findings);
        if (!glslang)
            continue;
        const auto found = glslang->check(program);
        if (!found)
            return found.error();
        findings.insert(findings.end(), found->begin(), found->end());
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
        console.note("glslangValidator is not installed: it was not asked (Debian: glslang-tools)");
    const auto findings = checkAll(*permutations, profilesFor(options.profiles), *glslang, console);
    console.endProgress();
    if (!findings)
        return console.error(findings.error()), ExitCode::Device;
    if (options.json)
        console.write(checkJson(permutations->size(), options.profiles, glslang->has_value(), *findings));
    else
        for (const Finding& finding : *findings)
            console.write(lineOf(finding));
    console.note(std::to_string(permutations->size()) + " programs checked, " +
                 std::to_string(findings->size()) + " findings");
    return findings->empty() ? ExitCode::Ok : ExitCode::Failed;
}

} // namespace franken::cli
