// SPDX-License-Identifier: MIT
#include "commands.h"
#include "depfile.h"
#include "dump_c.h"
#include "effects.h"
#include "franken/file_writer.h"
#include "json.h"
#include "program.h"
#include "selection.h"
#include "shader_test.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace franken::cli {
namespace {

namespace fs = std::filesystem;

using Permutations = std::vector<Permutation>;

/// Standard output, or a file that is whole or not there.
class Sink {
public:
    static Result<Sink> open(const std::string& output, Console& console) {
        if (output.empty())
            return Sink(console, std::nullopt);
        Result<FileWriter> file = FileWriter::open(output);
        if (!file)
            return file.error();
        return Sink(console, *std::move(file));
    }

    Result<void> write(std::string_view text) {
        if (m_file)
            return m_file->write(text);
        m_console->write(text);
        return {};
    }

    Result<void> finish() { return m_file ? m_file->commit() : Result<void>(); }

private:
    Sink(Console& console, std::optional<FileWriter> file) : m_console(&console), m_file(std::move(file)) {}

    Console* m_console;
    std::optional<FileWriter> m_file;
};

/// What else is done with each program of a document, and before the document is put in its place.
struct Beside {
    std::function<Result<void>(const Program&)> program = [](const Program&) { return Result<void>(); };
    std::function<Result<void>()> end = [] { return Result<void>(); };
};

// One document of all programs, of which only one is in memory at a time.
template<typename Document>
Result<void> writeDocument(Document document, const std::string& output, const Permutations& permutations,
                           Console& console, const Beside& beside = {}) {
    Result<Sink> sink = Sink::open(output, console);
    if (!sink)
        return sink.error();
    if (Result<void> written = sink->write(document.begin()); !written)
        return written;
    for (std::size_t i = 0; i < permutations.size(); ++i) {
        console.progress("programs written:", i, permutations.size());
        const Program program(permutations[i]);
        if (Result<void> written = beside.program(program); !written)
            return written;
        if (Result<void> written = sink->write(document.program(program)); !written)
            return written;
    }
    console.endProgress();
    if (Result<void> written = sink->write(document.end()); !written)
        return written;
    if (Result<void> done = beside.end(); !done)
        return done;
    return sink->finish();
}

Result<void> writeProgram(const fs::path& directory, const Program& program) {
    const fs::path file = directory / program.file;
    const std::pair<const char*, std::string> files[] = {{".vert", program.composed.vertex.text},
                                                         {".frag", program.composed.fragment.text},
                                                         {".shader_test", toShaderTest(program.composed)}};
    for (const auto& [extension, text] : files)
        if (auto written = writeFile(file.string() + extension, text, FileWriter::Sync::Later); !written)
            return written;
    return {};
}

Result<void> writeFolder(const fs::path& directory, const Permutations& permutations, Console& console) {
    std::error_code failed;
    fs::create_directories(directory, failed);
    if (failed)
        return Error{"file.write", directory.string(), "the folder cannot be made: " + failed.message(),
                     "choose a folder with write permission"};
    // Renamed into its place last, so that a folder with a manifest is a complete one.
    return writeDocument(DumpJson(Texts::InFiles), (directory / "manifest.json").string(), permutations,
                         console,
                         {.program = [&](const Program& program) { return writeProgram(directory, program); },
                          .end = [&] { return syncFolder(directory); }});
}

std::string textOf(const Program& program, std::optional<Stage> stage) {
    if (stage)
        return *stage == Stage::Vertex ? program.composed.vertex.text : program.composed.fragment.text;
    return program.composed.vertex.text + "\n" + program.composed.fragment.text;
}

Result<void> writeAs(const DumpOptions& options, const Permutations& permutations, Console& console) {
    switch (options.chosen()) {
    case DumpFormat::Files:
        return writeFolder(options.output, permutations, console);
    case DumpFormat::Json:
        return writeDocument(DumpJson(Texts::Inline), options.output, permutations, console);
    case DumpFormat::C:
        return writeDocument(DumpC(), options.output, permutations, console);
    case DumpFormat::Text:
        console.write(textOf(Program(permutations.front()), options.stage));
        break;
    }
    return {};
}

// What names the output as a whole; empty for standard output.
fs::path targetOf(const DumpOptions& options) {
    const bool files = options.chosen() == DumpFormat::Files;
    return files ? fs::path(options.output) / "manifest.json" : fs::path(options.output);
}

std::vector<fs::path> inputsOf(const DumpOptions& options) {
    std::vector<fs::path> inputs = effectFiles();
    if (const std::string& manifest = options.selection.manifest; !manifest.empty() && manifest != "-")
        inputs.insert(inputs.begin(), manifest);
    return inputs;
}

// What the output changes with: the files that it was made from, and this program, which has the snippets in
// it.
Result<void> writeDepfile(const DumpOptions& options) {
    if (options.depfile.empty())
        return {};
    std::vector<std::string> sources;
    for (const fs::path& input : inputsOf(options))
        sources.push_back(input.string());
    std::error_code unknown;
    if (const fs::path self = fs::read_symlink("/proc/self/exe", unknown); !unknown)
        sources.push_back(self.string());
    return writeFile(options.depfile, depfileText(targetOf(options).string(), sources));
}

// A folder gets files of these kinds; which ones is known only after composing.
bool isOutput(const DumpOptions& options, const fs::path& file) {
    if (options.chosen() != DumpFormat::Files)
        return false;
    const std::string extension = file.extension().string();
    return extension == ".vert" || extension == ".frag" || extension == ".shader_test";
}

Result<void> checkOutputs(const DumpOptions& options) {
    const std::vector<fs::path> inputs = inputsOf(options);
    std::vector<fs::path> outputs = {targetOf(options), options.depfile};
    for (const fs::path& input : inputs)
        if (isOutput(options, input))
            outputs.push_back(fs::path(options.output) / input.filename());
    for (const fs::path& output : outputs)
        if (const Result<void> checked = checkNotInput(output, inputs); !checked)
            return checked;
    std::error_code unknown;
    if (!options.depfile.empty() &&
        fs::weakly_canonical(options.depfile, unknown) == fs::weakly_canonical(targetOf(options), unknown))
        return Error{"file.overwrite", options.depfile, "the depfile would overwrite the output",
                     "choose another file for one of them"};
    return {};
}

} // namespace

ExitCode run(const DumpOptions& options, Console& console) {
    if (const Result<void> checked = checkOutputs(options); !checked)
        return console.error(checked.error()), ExitCode::Usage;
    const auto permutations = select(options.selection, console);
    if (!permutations)
        return ExitCode::Refused;
    if (options.chosen() == DumpFormat::Text && permutations->size() != 1) {
        console.error({"dump.several", "",
                       std::to_string(permutations->size()) + " programs do not fit into one text",
                       "write them to a directory with -o DIR, or use --format json or c"});
        return ExitCode::Usage;
    }
    Result<void> written = writeAs(options, *permutations, console);
    if (written)
        written = writeDepfile(options);
    if (!written)
        return console.error(written.error()), ExitCode::Device;
    if (!options.output.empty())
        console.note(std::to_string(permutations->size()) + " programs written to " + options.output);
    return ExitCode::Ok;
}

} // namespace franken::cli
