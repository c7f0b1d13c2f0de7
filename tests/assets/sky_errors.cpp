// SPDX-License-Identifier: MIT
// Prints how far the reflection of a sky is from brute force, as the table of generator/docs/sky.md:
//   sky_errors ORIENTATIONS SKY.hdr...
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "sky_sampling.h"
#include "sky_shader.h"

namespace {

using namespace franken;

struct Column {
    std::string name;
    float nDotV;
    std::vector<test::SkyError> errors;
};

bool addColumns(std::vector<Column>& columns, const std::filesystem::path& file, int orientations) {
    auto sky = test::loadExposed(file);
    if (!sky) {
        std::fprintf(stderr, "%s\n", sky.error().what.c_str());
        return false;
    }
    const std::vector<test::SkyError> errors = test::skyErrors(*sky, orientations);
    const std::string name = file.stem().string();
    columns.push_back({name + ", N·V 1", 1, errors});
    columns.push_back({name + ", N·V 0.2", 0.2f, errors});
    return true;
}

void print(const std::vector<Column>& columns) {
    std::string head = "| |", line = "|---|";
    for (const Column& column : columns) {
        head += " " + column.name + " |";
        line += "---|";
    }
    std::printf("%s\n%s\n", head.c_str(), line.c_str());
    for (const test::SkyMaterial& material : test::skyMaterials()) {
        std::printf("| %s |", material.name.c_str());
        for (const Column& column : columns) {
            for (const test::SkyError& error : column.errors)
                if (error.nDotV == column.nDotV && error.material == material.name)
                    std::printf(error.codes > test::goal(error) ? " **%.1f**" : " %.1f", error.codes);
            std::printf(" |");
        }
        std::printf("\n");
    }
}

} // namespace

int main(int count, char** words) {
    const int orientations = count > 2 ? std::atoi(words[1]) : 0;
    if (orientations < 1) {
        std::fprintf(stderr, "sky_errors ORIENTATIONS SKY.hdr...\n");
        return 2;
    }
    std::vector<Column> columns;
    for (int i = 2; i < count; ++i)
        if (!addColumns(columns, words[i], orientations))
            return 1;
    print(columns);
    return 0;
}
