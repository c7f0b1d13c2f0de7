// SPDX-License-Identifier: MIT
#include <cstring>
#include <iostream>

#include "franken/printable.h"
#include "gltf_writer.h"
#include "sky.h"

int main(int argc, char** argv) {
    constexpr const char* kUsage = "usage: make_model OUT.gltf   writes OUT.gltf, OUT.bin and OUT_*.png\n"
                                   "       make_model OUT.glb    writes one file\n"
                                   "       make_model OUT.hdr    writes a sky for it\n";
    if (argc == 2 && std::strcmp(argv[1], "--help") == 0) {
        std::cout << kUsage;
        return 0;
    }
    if (argc != 2 || argv[1][0] == '-') {
        std::cerr << kUsage;
        return 2;
    }
    const std::filesystem::path path = argv[1];
    const auto written = path.extension() == ".hdr" ? make_model::writeSky(path)
                                                    : make_model::writeGltf(make_model::makeModel(), path);
    if (!written) {
        std::cerr << "make_model: " << franken::printable(franken::toString(written.error())) << '\n';
        return 1;
    }
    return 0;
}
