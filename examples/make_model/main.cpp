// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

#include "flower.h"
#include "franken/printable.h"
#include "gltf_writer.h"
#include "sky.h"

int main(int argc, char** argv) {
    constexpr const char* kUsage =
        "usage: make_model OUT.gltf [urn|flower]   writes OUT.gltf, OUT.bin and OUT_*.png [urn]\n"
        "       make_model OUT.glb [urn|flower]    writes one file; the flower is animated\n"
        "       make_model OUT.hdr [WIDTH]   writes a sky for it, 2 to 8192 texels wide [4096]\n";
    if (argc == 2 && std::strcmp(argv[1], "--help") == 0) {
        std::cout << kUsage;
        return 0;
    }
    const std::filesystem::path path = argc > 1 ? argv[1] : "";
    const bool sky = path.extension() == ".hdr";
    const std::string what = argc == 3 ? argv[2] : "";
    const int width = sky && !what.empty() ? std::atoi(what.c_str()) : make_model::kSkyWidth;
    const bool known = sky || what.empty() || what == "urn" || what == "flower";
    if (argc < 2 || argc > 3 || argv[1][0] == '-' || width < 2 || width > 8192 || !known) {
        std::cerr << kUsage;
        return 2;
    }
    const auto written =
        sky ? make_model::writeSky(path, width)
            : make_model::writeGltf(what == "flower" ? make_model::makeFlower() : make_model::makeModel(),
                                    path);
    if (!written) {
        std::cerr << "make_model: " << franken::printable(written.error()) << '\n';
        return 1;
    }
    return 0;
}
