// SPDX-License-Identifier: MIT
// load_once FILE: loads one model or sky with the library's default limits, and prints one line,
// separated by tabs: the error's code or "ok", warnings, peak memory in KiB, processor seconds, the whole
// error. A process of its own for each file, because only that has a peak of its own.
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>

#include <sys/resource.h>

#include "franken/environment.h"
#include "franken/gltf.h"

namespace {

// Of this program only; getrusage() would count the memory of its parent before exec().
std::string peakMemory() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
        if (word == "VmHWM:" && status >> word)
            return word;
    return "0";
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    const rlimit limit{60, 60};
    setrlimit(RLIMIT_CPU, &limit);
    const std::filesystem::path path = argv[1];
    int warnings = 0;
    const auto count = [&warnings](franken::LogLevel, std::string_view) { ++warnings; };
    const std::clock_t start = std::clock();
    franken::Error error;
    if (path.extension() == ".gltf" || path.extension() == ".glb") {
        if (const auto scene = franken::loadGltf(path, {}, count); !scene)
            error = scene.error();
    } else if (const auto sky = franken::loadEnvironment(path); !sky) {
        error = sky.error();
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::cout << (error.code.empty() ? "ok" : error.code) << '\t' << warnings << '\t' << peakMemory() << '\t'
              << seconds << '\t' << error.where << '\t' << toString(error) << '\n';
    return 0;
}
