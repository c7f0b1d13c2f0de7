// SPDX-License-Identifier: MIT
// How many programs the build wrote: from the header, or from the list of the folder.
#include <cstdio>
#ifdef FOLDER
#include <fstream>
#include <string>
#else
#include "shaders.h"
#endif

int main() {
    int count = 0;
#ifdef FOLDER
    std::ifstream list(FOLDER "/manifest.json");
    for (std::string line; std::getline(list, line);)
        count += line.find("\"key\"") != std::string::npos;
#else
    for (const FrankenProgram* program = franken_programs; program->name != nullptr; ++program)
        ++count;
#endif
    std::printf("%d programs\n", count);
}
