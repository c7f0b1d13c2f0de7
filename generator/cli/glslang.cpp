// SPDX-License-Identifier: MIT
#include "glslang.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

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

struct Outcome {
    int spawnError; ///< 0 where the program ran.
    int exitCode;
};

// Runs it with its standard output and error in that file.
Outcome runInto(const fs::path& output, std::vector<std::string> arguments) {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t child = 0;
    const int failed = posix_spawnp(&child, kProgram, &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0)
        return {failed, 0};
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {0, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
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

Glslang::Glslang(fs::path directory) : m_directory(std::move(directory)) {}
Glslang::Glslang(Glslang&& other) noexcept : m_directory(std::exchange(other.m_directory, {})) {}

Glslang::~Glslang() {
    std::error_code ignored;
    if (!m_directory.empty())
        fs::remove_all(m_directory, ignored);
}

Result<std::optional<Glslang>> Glslang::open() {
    std::error_code failed;
    std::string pattern = (fs::temp_directory_path(failed) / "frankenshader.XXXXXX").string();
    if (failed || !mkdtemp(pattern.data()))
        return cannotRun(failed ? failed.message() : std::strerror(errno));
    Glslang glslang{fs::path(pattern)};
    const Outcome outcome = runInto(glslang.m_directory / "log", {kProgram, "--version"});
    if (outcome.spawnError == ENOENT)
        return std::optional<Glslang>();
    if (outcome.spawnError != 0)
        return cannotRun(std::strerror(outcome.spawnError));
    return std::optional<Glslang>(std::move(glslang));
}

Result<std::vector<Finding>> Glslang::check(const Program& program) const {
    const fs::path vertex = m_directory / "shader.vert", fragment = m_directory / "shader.frag";
    if (!write(vertex, program.composed.vertex.text) || !write(fragment, program.composed.fragment.text))
        return cannotRun("no temporary file can be written to " + m_directory.string());
    const Outcome outcome = runInto(m_directory / "log", {kProgram, vertex.string(), fragment.string()});
    if (outcome.spawnError != 0)
        return cannotRun(std::strerror(outcome.spawnError));
    const std::string log = read(m_directory / "log");
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
