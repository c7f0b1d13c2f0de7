// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw_scene.h"
#include "support/shell.h"

#include <cstdlib>

namespace franken::test {

inline constexpr const char* kUrn = URN_GLB;

/// The viewer as a shell sees it, in a folder of the running test's own.
class Viewer : public testing::Test {
protected:
    Outcome run(const std::string& arguments) const { return runIn(m_folder, VIEWER " " + arguments); }

    void SetUp() override {
        // OSMesa forgets a few hundred bytes with each context: for a viewer built with AddressSanitizer.
        const std::filesystem::path suppressions = m_folder / "leaks.txt";
        std::ofstream(suppressions) << "leak:libOSMesa\n";
        setenv("LSAN_OPTIONS", ("print_suppressions=0:suppressions=" + suppressions.string()).c_str(), 1);
        setenv("GALLIUM_DRIVER", "softpipe", 0);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    }

    /// Copies generator/glsl to `glsl`.
    void copySnippets() const {
        std::filesystem::copy(std::filesystem::path(FRANKEN_SOURCE_DIR) / "generator/glsl", m_folder / "glsl",
                              std::filesystem::copy_options::recursive);
    }

    const std::filesystem::path m_folder = emptyTestFolder();
};

/// What --stats counts of one picture.
struct ViewerStats {
    unsigned compiled = 0, linked = 0, draws = 0, failed = 0;    ///< Of the warm-up.
    unsigned frameCompiled = 0, frameLinked = 0, primitives = 0; ///< Of the frame.
    float mebibytes = 0;
};

/// Of the last picture in an output. Adds a failure where there is none.
inline ViewerStats lastStats(const std::string& output) {
    ViewerStats stats;
    const std::size_t at = output.rfind("warm-up: ");
    const int read =
        std::sscanf(output.c_str() + (at == std::string::npos ? output.size() : at),
                    "warm-up: %u shaders compiled, %u programs linked, %u draws, %u failed, %*f ms\n"
                    "frame: %u shaders compiled, %u programs linked, %u primitives drawn, %*u out of view\n"
                    "memory: %f MiB",
                    &stats.compiled, &stats.linked, &stats.draws, &stats.failed, &stats.frameCompiled,
                    &stats.frameLinked, &stats.primitives, &stats.mebibytes);
    EXPECT_EQ(read, 8) << output;
    return stats;
}

} // namespace franken::test
