// SPDX-License-Identifier: MIT
// What the kiosk says to whoever starts it, and pictures of it without a screen.
#include "franken/file.h"
#include "franken/image.h"
#include "kiosk/report/screenshot.h"
#include "kiosk/screen.h"
#include "kiosk/show/program_list.h"
#include "support/shell.h"

#include <gtest/gtest.h>

#include <mutex>

namespace franken::test {
namespace {

namespace fs = std::filesystem;
using namespace kiosk;

class KioskCommands : public testing::Test {
protected:
    Outcome run(const std::string& arguments, const std::string& environment = {}) const {
        return runIn(m_folder, environment + " " KIOSK " " + arguments);
    }
    Image draw(const std::string& arguments) const {
        const Outcome drawn = run("--frame out.png --size 200x120 " + arguments);
        EXPECT_EQ(drawn.code, 0) << drawn.err;
        const auto bytes = readFile(m_folder / "out.png", 1 << 20);
        const auto image = bytes ? decodeImage(*bytes) : Result<Image>(bytes.error());
        EXPECT_TRUE(image) << arguments;
        return image ? *image : Image{};
    }
    fs::path m_folder = emptyTestFolder();
};

struct Mistake {
    const char* arguments;
    int code;
    const char* says;
};

TEST_F(KioskCommands, EachMistakeIsSaidWithWhatToDo) {
    const Mistake mistakes[] = {
        {"--backend kmss", 2, "kms"},
        {"--frame out.png --size 12", 2, "'12' is not WIDTHxHEIGHT in pixels"},
        {"--frame out.png --loading 2", 2, "--loading"},
        {"--loading 0.5", 2, "--frame"},
        {"--frame out.png --time soon", 2, "--time"},
        {"--config none.toml", 3, "none.toml"},
        {"--content.seconds soon", 3, "content.seconds"},
        {"--show.tone-map akes", 3, "\"aces\" was probably meant"},
        {"--frame out.png none.glb", 4, "there is no model to draw"},
        {"--frame out.png", 4, "name one, or a folder that has one"},
    };
    for (const Mistake& mistake : mistakes) {
        const Outcome outcome = run(mistake.arguments);
        EXPECT_EQ(outcome.code, mistake.code) << mistake.arguments << "\n" << outcome.err;
        EXPECT_NE(outcome.err.find(mistake.says), std::string::npos) << mistake.arguments << "\n"
                                                                     << outcome.err;
        EXPECT_FALSE(fs::exists(m_folder / "out.png"));
    }
}

TEST_F(KioskCommands, LinesForTheJournalBeginWithTheirSeverity) {
    const std::string arguments = "--frame out.png none.glb";
    const Outcome journal = run(arguments, "JOURNAL_STREAM=8:1");
    EXPECT_NE(journal.err.find("\n<6>1 model\n<3>/"), std::string::npos) << journal.err;
    EXPECT_NE(journal.err.find("none.glb is skipped: "), std::string::npos) << journal.err;
    const Outcome terminal = run(arguments);
    EXPECT_NE(terminal.err.find("\nkiosk: 1 model\nkiosk: error: /"), std::string::npos) << terminal.err;
}

/// Columns of the bar's row that are brighter than so much.
int columnsAbove(const Image& image, int threshold) {
    int columns = 0;
    for (int x = 0; x < image.width; ++x) {
        const auto at = static_cast<std::size_t>((image.height / 2 * image.width + x) * 4);
        columns += image.rgba.at(at) > threshold ? 1 : 0;
    }
    return columns;
}

TEST_F(KioskCommands, TheLoadingPicturesBarIsAsLongAsWhatIsDone) {
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        const Image image = draw("--show.font none.ttf --loading " + std::to_string(share));
        ASSERT_EQ(image.width, 200);
        EXPECT_NEAR(columnsAbove(image, 100), 0.4 * 200 * share, 1) << share;
        EXPECT_NEAR(columnsAbove(image, 20), 0.4 * 200, 1) << "all of the bar is to be seen";
    }
    const Image turned = draw("--show.font none.ttf --screen.rotation 90 --loading 0.5");
    int bright = 0;
    for (int y = 0; y < turned.height; ++y)
        bright +=
            turned.rgba.at(static_cast<std::size_t>((y * turned.width + turned.width / 2) * 4)) > 100 ? 1 : 0;
    EXPECT_NEAR(bright, 0.4 * 120 * 0.5, 1) << "along the panel's other side";
}

TEST_F(KioskCommands, WithoutAStateFolderNothingIsKeptAndScreenshotsSayWhy) {
    Config config;
    config.files.state = "";
    EXPECT_TRUE(surfaceOptionsOf(config, {}).shaderCache.empty());
    config.files.state = (m_folder / "state").string();
    EXPECT_EQ(surfaceOptionsOf(config, {}).shaderCache, (m_folder / "state/mesa").string());
    std::string said;
    const Log log = [&said](LogLevel, std::string_view text) { said += text; };
    Screenshots({}, log).write({});
    EXPECT_NE(said.find("no screenshot: files.state is empty"), std::string::npos) << said;
    said.clear();
    {
        ProgramList none({}, log);
        none.add({});
        none.keep();
    }
    EXPECT_EQ(said, "");
}

TEST_F(KioskCommands, AListOfProgramsThatCannotBeWrittenIsKeptLater) {
    const fs::path folder = m_folder / "state", file = folder / "programs.manifest";
    std::mutex mutex;
    std::string said;
    const Log log = [&](LogLevel, std::string_view text) {
        const std::lock_guard lock(mutex);
        said += std::string(text) + "\n";
    };
    {
        ProgramList list(file, log);
        EXPECT_TRUE(list.read().empty());
        list.add({});
        list.keep();
        list.keep(); // At once: whichever comes too early is left to the next.
    }
    EXPECT_EQ(said.find("is not kept"), said.rfind("is not kept")) << "told once:\n" << said;
    EXPECT_NE(said.find("the list of programs is not kept"), std::string::npos) << said;
    {
        ProgramList list(file, log);
        list.add({});
        list.add({});
        fs::create_directories(folder);
    } // Kept at the end at the latest.
    EXPECT_EQ(ProgramList(file, log).read().size(), 1U);
}

} // namespace
} // namespace franken::test
