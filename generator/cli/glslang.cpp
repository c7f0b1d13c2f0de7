// SPDX-License-Identifier: MIT
#include "glslang.h"

#include "child_process.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

constexpr char kProgram[] = "glslangValidator";

Error cannotRun(const std::string& reason) {
    return {"glslang.run", kProgram, "cannot be run: " + reason,
            "set TMPDIR to a folder with write permission"};
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

/// A file that was given to the compiler.
struct Compiled {
    std::size_t program;
    const ComposedStage* stage;
};

// The compiler ends with a count of its errors, which is none of them.
bool isFinding(std::string_view line) {
    return (line.starts_with("ERROR: 0:") || line.starts_with("WARNING: 0:")) &&
           line.find("compilation terminated") == std::string_view::npos;
}

Finding findingOf(std::string_view line, const std::string& program, const ComposedStage& stage) {
    const std::string annotated = annotateLog(line, stage);
    const std::size_t bracket = annotated.rfind(" [generator/");
    Finding finding{program, "glslang", "", annotated.substr(0, bracket), ""};
    if (bracket != std::string::npos)
        finding.where = annotated.substr(bracket + 2, annotated.find(']', bracket) - bracket - 2);
    return finding;
}

// The log has each file's name on a line, and below it what there is to say of it.
std::vector<std::vector<Finding>> findingsIn(const std::string& log, std::span<const Program> programs,
                                             const std::map<std::string, Compiled, std::less<>>& files) {
    std::vector<std::vector<Finding>> findings(programs.size());
    const Compiled* current = nullptr;
    for (const std::string_view line : linesOf(log)) {
        if (const auto file = files.find(line); file != files.end())
            current = &file->second;
        else if (current && isFinding(line))
            findings[current->program].push_back(
                findingOf(line, programs[current->program].name, *current->stage));
    }
    return findings;
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

Result<std::vector<std::vector<Finding>>> Glslang::check(std::span<const Program> programs) const {
    std::vector<std::string> arguments = {kProgram};
    std::map<std::string, Compiled, std::less<>> files;
    for (std::size_t i = 0; i < programs.size(); ++i)
        for (const auto& [extension, stage] :
             {std::pair{".vert", &Composed::vertex}, {".frag", &Composed::fragment}}) {
            const fs::path file = m_folder.path() / (std::to_string(i) + extension);
            if (!write(file, (programs[i].composed.*stage).text))
                return cannotRun("no temporary file can be written to " + m_folder.path().string());
            arguments.push_back(file.string());
            files.emplace(file.string(), Compiled{i, &(programs[i].composed.*stage)});
        }
    const fs::path output = m_folder.path() / "log";
    const Outcome outcome = runProgram(arguments, {.out = output});
    if (outcome.spawnError != 0)
        return cannotRun(std::strerror(outcome.spawnError));
    std::vector<std::vector<Finding>> findings = findingsIn(read(output), programs, files);
    const bool explained = std::any_of(findings.begin(), findings.end(),
                                       [](const std::vector<Finding>& each) { return !each.empty(); });
    if (outcome.exitCode == 0 || (explained && outcome.exitCode < 128))
        return findings;
    if (programs.size() > 1)
        return checkEach(programs);
    findings.front().push_back(
        {programs.front().name, "glslang", "", "exit code " + std::to_string(outcome.exitCode), ""});
    return findings;
}

Result<std::vector<std::vector<Finding>>> Glslang::checkEach(std::span<const Program> programs) const {
    std::vector<std::vector<Finding>> findings;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        auto found = check(programs.subspan(i, 1));
        if (!found)
            return found;
        findings.push_back(std::move(found->front()));
    }
    return findings;
}

} // namespace franken::cli
