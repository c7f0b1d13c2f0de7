// SPDX-License-Identifier: MIT
// faulty_calls append FILE NAME... | read FILE | write FILE TEXT | sync FOLDER: does that once, under
// FRANKEN_FAULT. Prints how many system calls it took, what came of it, and which calls they were; exits with
// 1 where it was told of an error.
#include "faulty_calls.h"
#include "franken/file.h"
#include "franken/file_writer.h"
#include "franken/manifest.h"

#include <cstdio>
#include <string_view>

using namespace franken;

namespace {

std::vector<ProgramUse> usesOf(int argc, char** argv) {
    std::vector<ProgramUse> uses;
    for (int i = 3; i < argc; ++i) {
        const auto parsed = parseManifest(argv[i], "argument");
        if (parsed)
            uses.insert(uses.end(), parsed->begin(), parsed->end());
    }
    return uses;
}

Result<void> act(std::string_view what, int argc, char** argv) {
    if (what == "append")
        return appendToManifest(argv[2], usesOf(argc, argv));
    if (what == "write")
        return writeFile(argv[2], std::string_view(argv[3]));
    if (what == "sync")
        return syncFolder(argv[2]);
    if (const auto read = readManifest(argv[2]); !read)
        return read.error();
    return {};
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3)
        return 2;
    countCalls();
    const Result<void> done = act(argv[1], argc, argv);
    std::printf("%d %s\n%s\n", countCalls(), done ? "ok" : toString(done.error()).c_str(), namesOfCalls());
    return done ? 0 : 1;
}
