// SPDX-License-Identifier: MIT
// After a warm-up, the Pi's own drivers compile nothing in a kiosk's thousand frames.
#include "measure.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

namespace franken::test {
namespace {

class PiFrames : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!compilers().compiler)
            GTEST_SKIP() << compilers().whyNot;
    }

    // What pi_frames prints: numbers by word.
    std::map<std::string, int> run(const std::string& options) {
        const std::string gpu = GetParam(), driver = gpu.substr(0, 3);
        const std::string library = std::string(std::getenv("FRANKEN_QPU")) + "/lib";
        std::string command = "exec env MESA_SHADER_CACHE_DISABLE=true LD_LIBRARY_PATH=" + library +
                              " LD_PRELOAD=" + library + "/lib" + driver + "_noop_drm_shim.so" +
                              " GBM_BACKENDS_PATH=" + library + "/gbm MESA_LOADER_DRIVER_OVERRIDE=" + driver;
        command += driver == "vc4" ? " VC4_DEBUG=shaderdb" : "";
        command += gpu == "v3d71" ? " V3D_SHIM_VER=71" : "";
        command += " ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0 " PI_FRAMES " " + options;
        std::FILE* pipe = popen(command.c_str(), "r");
        std::map<std::string, int> numbers;
        std::array<char, 256> line{};
        while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
            std::istringstream words(line.data());
            std::string word;
            int number = -1;
            if (words >> word >> number)
                numbers[word] = number;
            else
                m_driver = line.data();
        }
        EXPECT_EQ(pclose(pipe), 0) << command;
        EXPECT_NE(m_driver.find(driver == "vc4" ? "VC4" : "V3D"), std::string::npos) << m_driver;
        return numbers;
    }

private:
    std::string m_driver;
};

INSTANTIATE_TEST_SUITE_P(Gpus, PiFrames, testing::Values("vc4", "v3d42", "v3d71"),
                         [](const auto& gpu) { return std::string(gpu.param); });

TEST_P(PiFrames, CompileNothingAfterAWarmUp) {
    std::map<std::string, int> numbers = run("");
    EXPECT_GT(numbers["warm-up"], numbers["programs"]) << "the driver reports what it compiles";
    ASSERT_EQ(numbers.count("frames"), 1u);
    EXPECT_EQ(numbers["frames"], 0);
    std::cout << GetParam() << ": " << numbers["warm-up"] << " compiles in the warm-up of "
              << numbers["programs"] << " programs\n";
}

TEST_P(PiFrames, CompileNothingAfterAWarmUpWithFourSamplesAPixel) {
    std::map<std::string, int> numbers = run("--smooth");
    ASSERT_EQ(numbers.count("frames"), 1u);
    EXPECT_EQ(numbers["frames"], 0);
    const int late = run("--late-smooth")["frames"];
    EXPECT_GT(late, 0) << "the driver compiles for samples, and so does the warm-up";
    std::cout << GetParam() << ": " << late << " compiles in frames after a warm-up without samples\n";
}

TEST_P(PiFrames, CompileWithoutOne) {
    EXPECT_GT(run("--cold")["frames"], 50) << "what the test above counts does occur";
}

} // namespace
} // namespace franken::test
