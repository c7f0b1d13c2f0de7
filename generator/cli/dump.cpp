// SPDX-License-Identifier: MIT
#include "commands.h"
#include "json.h"
#include "program.h"
#include "selection.h"
#include "shader_test.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

Error unwritable(const fs::path& path, const std::string& reason) {
    return {"dump.write", path.string(), "cannot be written: " + reason,
            "name a directory that can be written with -o"};
}

// The old file or the whole new one, never half of it.
Result<void> writeFile(const fs::path& path, std::string_view text) {
    const fs::path part = path.string() + ".part";
    errno = 0;
    std::ofstream out(part, std::ios::binary);
    out << text;
    out.close();
    if (!out)
        return unwritable(part, std::strerror(errno));
    std::error_code failed;
    fs::rename(part, path, failed);
    if (failed)
        return unwritable(path, failed.message());
    return {};
}

Result<void> writeProgram(const fs::path& directory, const Program& program) {
    const fs::path file = directory / program.file;
    const std::pair<const char*, std::string> files[] = {{".vert", program.composed.vertex.text},
                                                         {".frag", program.composed.fragment.text},
                                                         {".shader_test", toShaderTest(program.composed)}};
    for (const auto& [extension, text] : files)
        if (auto written = writeFile(file.string() + extension, text); !written)
            return written;
    return {};
}

Result<void> writeAll(const fs::path& directory, const std::vector<Program>& programs, Console& console) {
    std::error_code failed;
    fs::create_directories(directory, failed);
    if (failed)
        return unwritable(directory, failed.message());
    for (std::size_t i = 0; i < programs.size(); ++i) {
        console.progress("programs written:", i, programs.size());
        if (auto written = writeProgram(directory, programs[i]); !written)
            return written;
    }
    console.endProgress();
    // Last, so that a directory with a manifest is a complete one.
    return writeFile(directory / "manifest.json", dumpJson(programs, Texts::InFiles));
}

std::string textOf(const Program& program, std::optional<Stage> stage) {
    if (stage)
        return *stage == Stage::Vertex ? program.composed.vertex.text : program.composed.fragment.text;
    return program.composed.vertex.text + "\n" + program.composed.fragment.text;
}

} // namespace

ExitCode run(const DumpOptions& options, Console& console) {
    const auto selected = select(options.selection, console);
    if (!selected)
        return ExitCode::Refused;
    const std::vector<Program> programs(selected->begin(), selected->end());
    if (!options.directory.empty()) {
        if (auto written = writeAll(options.directory, programs, console); !written) {
            console.endProgress();
            console.error(written.error());
            return ExitCode::Device;
        }
        console.note(std::to_string(programs.size()) + " programs written to " + options.directory);
    } else if (options.json) {
        console.write(dumpJson(programs, Texts::Inline));
    } else if (programs.size() == 1) {
        console.write(textOf(programs.front(), options.stage));
    } else {
        console.error({"dump.several", "", std::to_string(programs.size()) + " programs are no one text",
                       "write them to a directory with -o DIR, or use --json"});
        return ExitCode::Usage;
    }
    return ExitCode::Ok;
}

} // namespace franken::cli
