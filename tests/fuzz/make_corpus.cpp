// SPDX-License-Identifier: MIT
// make_corpus FOLDER NAMES: writes what the fuzzers start from: the malformed files of the tests, and the
// sound ones that they were made of; small fonts; the named permutations in the file NAMES.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#ifdef FRANKEN_TINYEXR
#include "exr_file.h"
#endif
#include "franken/baked_sky.h"
#include "malformed/malformed.h"
#include "malformed/pictures.h"
#include "support/font_builder.h"

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSeed = 16384; ///< A fuzzer gets nowhere with larger ones.

void write(const fs::path& folder, std::string name, const std::string& bytes) {
    if (bytes.size() > kMaxSeed)
        return;
    std::replace(name.begin(), name.end(), '/', '_');
    fs::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << bytes;
}

std::string bakedSky() {
    franken::BakedSky sky;
    sky.sun = franken::Sun{.direction = {0, -1, 0}, .color = {1, 1, 1}};
    const auto bytes = franken::encodeBakedSky(sky);
    return {bytes.begin(), bytes.end()};
}

/// The smallest of each kind: one face of a texel, and pictures of a few texels.
void writeFloatSkies(const fs::path& folder) {
    std::string hdre("HDRE\0\0\x40\x40\1\0\1\0\0\0\0\0\3\0\x20\0\0\1\0\0\0\0\0\0\3\0", 30);
    hdre.resize(256 + 6 * 6 * 12);
    write(folder, "hdre", hdre);
#ifdef FRANKEN_TINYEXR
    for (int compression = 0; compression < 5; ++compression)
        for (const int tile : {0, 4})
            write(
                folder, "exr" + std::to_string(compression) + "-" + std::to_string(tile),
                franken::test::exrBytes({.width = 8, .height = 4, .compression = compression, .tile = tile}));
#endif
}

void writeFonts(const fs::path& folder) {
    using namespace franken::test;
    const auto writeFont = [&](const char* name, const FontFile& font) {
        const std::vector<std::uint8_t> bytes = font.bytes();
        write(folder, name, {bytes.begin(), bytes.end()});
    };
    FontFile font = soundFont();
    writeFont("groups", font);
    font.tables["GPOS"] = pairPositioning();
    writeFont("positioning", font);
    font.tables["cmap"] = segmentMap();
    font.setGlyphs(soundGlyphs(), false);
    font.tables["head"].replace(50, 2, 2, '\0');
    writeFont("segments", font);
}

/// Channels by path and interpolation, of two keys each, and a time (fuzz_pose.cpp).
void writePoses(const fs::path& folder) {
    constexpr std::array<int, 5> kWidths = {3, 4, 3, 2, 1};
    for (int path = 0; path < static_cast<int>(kWidths.size()); ++path)
        for (int interpolation = 0; interpolation < 3; ++interpolation) {
            std::string bytes{'\0', static_cast<char>(path)};
            if (path != 3) // Weights have but one node.
                bytes += '\1';
            bytes += {static_cast<char>(interpolation), '\2'};
            std::vector<float> numbers;
            for (const float time : {0.25f, 1.0f}) {
                numbers.push_back(time);
                for (int i = 0; i < kWidths[static_cast<std::size_t>(path)] * (interpolation == 2 ? 3 : 1);
                     ++i)
                    numbers.push_back(0.5f * static_cast<float>(i) - time);
            }
            numbers.insert(numbers.end(), {0.5f, 3.25f});
            bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float));
            write(folder, std::to_string(path) + "-" + std::to_string(interpolation), bytes);
        }
}

void writeNames(const fs::path& folder, const std::string& file) {
    std::ifstream in(file);
    std::stringstream whole;
    whole << in.rdbuf();
    write(folder / "manifest", "named", whole.str());
    write(folder / "manifest", "comments", "# nothing\n\n  \t# here\r\nsurface # and here");
    int number = 0;
    for (std::string line; std::getline(whole, line);)
        if (const std::string name = line.substr(0, line.find_first_of(" #")); !name.empty())
            write(folder / "permutation", std::to_string(number++), name);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    const fs::path folder = argv[1];
    for (const bool binary : {false, true})
        write(folder / "gltf", binary ? "sound.glb" : "sound.gltf", soundModel().bytes(binary));
    for (const MalformedFile& file : malformedFiles())
        if (!file.name.starts_with("schema/")) // one change each of the sound model: the fuzzer makes its own
            write(folder / (file.name.starts_with("sky/") ? "sky" : "gltf"), file.name, file.bytes);
    for (const int type : {0, 2, 3, 4, 6})
        write(folder / "sky", "png" + std::to_string(type), pictures::png(16, 8, 8, type));
    for (const bool progressive : {false, true})
        write(folder / "sky", progressive ? "progressive" : "baseline",
              pictures::jpeg(32, 16, progressive, 5));
    write(folder / "sky", "baked", bakedSky());
    writeFloatSkies(folder / "sky");
    writeFonts(folder / "font");
    writePoses(folder / "pose");
    writeNames(folder, argv[2]);
    for (const char* part : {"gltf", "font", "pose", "sky", "manifest", "permutation"}) {
        const auto count = std::distance(fs::directory_iterator(folder / part), fs::directory_iterator());
        std::cout << part << ": " << count << " seeds\n";
    }
    return 0;
}
