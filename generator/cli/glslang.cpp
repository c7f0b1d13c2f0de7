// SPDX-License-Identifier: MIT
#include "glslang.h"

#include "child_process.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kProgram[] = "glslangValidator";

Error cannotRun(const std::string& reason) {
    return {"glslang.run", kProgram, "cannot be run: " + reason, "see that TMPDIR can be written to"};
}

bool write(const fs::path& path, std::string_view text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    out.close();
    return static_cast<bool>(out);
}

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

// The compiler ends with a count of its errors, which is none of them.
void addFindings(std::vector<Finding>& findings, const Program& program, std::string_view log,
                 const ComposedStage& stage) {
    const std::string annotated = annotateLog(log, stage);
    for (const std::string_view line : linesOf(annotated)) {
        const bool located = line.starts_with("ERROR: 0:") || line.starts_with("WARNING: 0:");
        if (!located || line.find("compilation terminated") != std::string_view::npos)
            continue;
        const std::size_t bracket = line.rfind(" [generator/");
        Finding finding{program.name, "glslang", "", std::string(line.substr(0, bracket)), ""};
        if (bracket != std::string_view::npos)
            finding.where = line.substr(bracket + 2, line.size() - bracket - 3);
        findings.push_back(std::move(finding));
    }
}

} // namespace

Result<std::optional<Glslang>> Glslang::open() {
    Result<TemporaryFolder> folder = TemporaryFolder::make();
    if (!folder)
        return cannotRun(folder.error().what);
    const Outcome outcome = runProgram({kProgram, "--version"}, {.out = folder->path() / "log"});
    if (outcome.spawnError == ENOENT)
        return std::optional<Glslang>();
    if (outcome.spawnError != 0)
        return cannotRun(std::strerror(outcome.spawnError));
    return std::optional(Glslang(*std::move(folder)));
}

Result<std::vector<Finding>> Glslang::check(const Program& program) const {
    const fs::path vertex = m_folder.path() / "shader.vert", fragment = m_folder.path() / "shader.frag";
    const fs::path output = m_folder.path() / "log";
    if (!write(vertex, program.composed.vertex.text) || !write(fragment, program.composed.fragment.text))
        return cannotRun("no temporary file can be written to " + m_folder.path().string());
    const Outcome outcome = runProgram({kProgram, vertex.string(), fragment.string()}, {.out = output});
    if (outcome.spawnError != 0)
        return cannotRun(std::strerror(outcome.spawnError));
    const std::string log = read(output);
    const std::size_t border = std::min(log.find(fragment.string()), log.size());
    std::vector<Finding> findings;
    addFindings(findings, program, std::string_view(log).substr(0, border), program.composed.vertex);
    addFindings(findings, program, std::string_view(log).substr(border), program.composed.fragment);
    if (outcome.exitCode != 0 && findings.empty())
        findings.push_back(
            {program.name, "glslang", "", "exit code " + std::to_string(outcome.exitCode), ""});
    return findings;
}

} // namespace franken::cli
