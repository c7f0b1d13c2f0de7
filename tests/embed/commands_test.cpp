// SPDX-License-Identifier: MIT
// The command lines of README.md and of the handbook, run as they are printed, in a folder with the files
// that they name.
#include "support/shell.h"

#include <algorithm>
#include <vector>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

/// The command lines under a heading, without their comments.
std::vector<std::string> commandsOf(const std::string& heading) {
    std::ifstream block(fs::path(BLOCKS) / (heading + ".sh"));
    std::vector<std::string> commands;
    for (std::string line; std::getline(block, line);) {
        line.resize(std::min(line.find('#'), line.size()));
        line.resize(line.find_last_not_of(' ') + 1);
        if (!line.empty())
            commands.push_back(line);
    }
    return commands;
}

bool contains(const std::string& command, const std::string& word) {
    return command.find(word) != std::string::npos;
}

class Commands : public testing::Test {
protected:
    Outcome run(const std::string& command) const {
        return runIn(m_folder, "PATH='" PROGRAMS "':$PATH; " + command);
    }

    void expectSuccess(const std::string& command) const {
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
    }

    const fs::path m_folder = emptyTestFolder();
};

/// The scripts install packages and build for minutes: CI runs them. Here they only have to be there.
TEST_F(Commands, TheFirstScreenNamesScripts) {
    const std::vector<std::string> commands = commandsOf("frankenshader");
    EXPECT_EQ(commands.size(), 2u);
    for (const std::string& command : commands)
        EXPECT_EQ(access((fs::path(FRANKEN_SOURCE_DIR) / command).c_str(), X_OK), 0) << command;
}

TEST_F(Commands, OfTheTool) {
    expectSuccess("echo basecolor+sun1 >warm.txt && frankenshader dump --manifest warm.txt -o shaders");
    const std::vector<std::string> commands = commandsOf("the-command-line-tool");
    EXPECT_GE(commands.size(), 8u);
    for (const std::string& command : commands)
        if (contains(command, " diff basecolor"))
            EXPECT_EQ(run(command).code, 1) << command << ": the programs differ";
        else if (!contains(command, " cost "))
            expectSuccess(command);
}

TEST_F(Commands, OfTheToolThatNeedTheCompilersOfThePi) {
    for (const std::string& command : commandsOf("the-command-line-tool")) {
        if (!contains(command, " cost "))
            continue;
        const Outcome outcome = run(command);
        if (contains(outcome.err, "[cost.toolchain]"))
            GTEST_SKIP() << outcome.err;
        EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
}

/// A viewer that watches runs until it is ended.
std::string untilThePictureIsThere(const std::string& command) {
    return command +
           " 2>watch & until grep -q wrote watch || ! kill -0 $!; do sleep 0.1; done; kill $!; wait $!";
}

TEST_F(Commands, OfTheViewer) {
    for (const char* folder : {"generator", "examples"})
        fs::create_directory_symlink(fs::path(FRANKEN_SOURCE_DIR) / folder, m_folder / folder);
    expectSuccess("make_model urn.glb && cp urn.glb city.glb");
    const std::vector<std::string> commands = commandsOf("the-viewer");
    EXPECT_GE(commands.size(), 7u);
    for (const std::string& command : commands)
        expectSuccess(contains(command, "--watch") ? untilThePictureIsThere(command) : command);
    EXPECT_TRUE(fs::exists(m_folder / "urn.png"));
    EXPECT_TRUE(fs::exists(m_folder / "kiosk.txt"));
}

/// A grey sky of 64 x 32 texels with a sun of one texel: large skies bake for half a minute.
void writeSky(const fs::path& path) {
    std::string texels;
    for (int i = 0; i < 64 * 32; ++i)
        texels += i == 64 * 10 + 30 ? "\x80\x80\x80\x8C" : "\x80\x80\x80\x81";
    std::ofstream(path, std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n" << texels;
}

TEST_F(Commands, OfASky) {
    expectSuccess("make_model urn.glb");
    writeSky(m_folder / "lake.hdr");
    const std::vector<std::string> commands = commandsOf("a-sky");
    EXPECT_EQ(commands.size(), 2u);
    for (const std::string& command : commands)
        expectSuccess(command);
}

/// Runs the command lines under a heading of the handbook.
class Handbook : public Commands {
protected:
    void expectSuccessOf(const std::string& heading, std::size_t count) const {
        const std::vector<std::string> commands = commandsOf(kFolder + heading);
        EXPECT_EQ(commands.size(), count) << heading;
        for (const std::string& command : commands)
            expectSuccess(command);
    }

    const std::string kFolder = "toolchains/docs/handbook/";
};

TEST_F(Handbook, OfLight) {
    expectSuccess("make_model urn.glb");
    expectSuccessOf("units-and-exposure", 3);
    expectSuccessOf("why-is-it-black-", 5);
    EXPECT_TRUE(fs::exists(m_folder / "occlusion.png"));
}

TEST_F(Handbook, OfAnEffect) {
    expectSuccess("make_model urn.glb");
    fs::copy(fs::path(BLOCKS) / (kFolder + "the-file.glsl"), m_folder / "glow.glsl");
    expectSuccessOf("try-it", 3);
    EXPECT_TRUE(fs::exists(m_folder / "glow.png"));
}

TEST_F(Commands, OfTheToolkits) {
    if (run("command -v toolkit_sdl2").code != 0)
        GTEST_SKIP() << "needs SDL 2 (Debian package libsdl2-dev)";
    const std::vector<std::string> commands = commandsOf("examples/toolkits/frankenshader-beside-a-toolkit");
    EXPECT_EQ(commands.size(), 2u);
    for (const std::string& command : commands)
        expectSuccess("export GALLIUM_DRIVER=softpipe LIBGL_ALWAYS_SOFTWARE=1; " + command);
    EXPECT_TRUE(fs::exists(m_folder / "sdl2.png"));
}

} // namespace
} // namespace franken::test
