// SPDX-License-Identifier: MIT
// The command lines of README.md and of the guide for toolkits, run as they are printed, in a folder with the
// files that they name. Those of the handbook are run by the build of the documentation, which shows what
// they draw (toolchains/docs/handbook.py).
#include "support/draw_scene.h"
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

// The picture of the page is the one that its commands draw. 2 codes in a hundredth of the pixels are left to
// other versions of Mesa.
TEST_F(Commands, OfWhatMoves) {
    const std::vector<std::string> commands = commandsOf("what-moves");
    EXPECT_EQ(commands.size(), 3u);
    for (const std::string& command : commands)
        expectSuccess("export GALLIUM_DRIVER=softpipe; " + command);
    EXPECT_TRUE(fs::exists(m_folder / "frame_0024.png"));
    const fs::path printed = fs::path(FRANKEN_SOURCE_DIR) / "examples/day.png";
    EXPECT_LT(fs::file_size(printed), 60000u);
    const Picture picture = readPicture(m_folder / "day.png");
    const Difference difference = compareLit(picture, readPicture(printed));
    EXPECT_LE(difference.shareAbove(2), 0.01) << writeDifference("day", picture, readPicture(printed));
}

/// Its other commands are run by the documentation's build.
TEST_F(Commands, TheHandbookPrintsTheFirstProgramAsItIs) {
    std::string printed = readText(fs::path(BLOCKS) / "toolchains/docs/handbook/the-program.inc");
    printed.erase(0, printed.find('\n') + 1); // #line
    const std::string program = readText(FRANKEN_SOURCE_DIR "/examples/embed/first/main.cpp");
    EXPECT_EQ(program, "// SPDX-License-Identifier: MIT\n" + printed);
    const std::string page = readText(FRANKEN_SOURCE_DIR "/toolchains/docs/handbook/first.md");
    const std::string project = readText(FRANKEN_SOURCE_DIR "/examples/embed/first/CMakeLists.txt");
    EXPECT_NE(page.find("```cmake\n" + project.substr(project.find("cmake_minimum_required"))),
              std::string::npos);
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
