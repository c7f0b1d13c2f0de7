// SPDX-License-Identifier: MIT
// Golden pictures: written by the target `update-goldens` alone, and then looked at by a person. Softpipe of
// one version of Mesa draws the same bits on every machine and on both backends.
#include "franken/png.h"
#include "picture_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(FRANKEN_SOURCE_DIR) / "tests/golden/pictures";
constexpr const char* kUrn = URN_GLB; // Written by make_model in the build tree.
constexpr const char* kEngine =
    "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";

bool updating() { return std::getenv("FRANKEN_UPDATE_GOLDENS") != nullptr; }

class PictureGolden : public PictureTest {
protected:
    PictureGolden() : PictureTest({160, 120}) {}

    void check(const std::string& name, const Shot& shot);

    /// "softpipe Mesa 22.3.6", whatever the backend puts around it.
    std::string driver() {
        const std::string text = surface().driver();
        const std::size_t mesa = text.find("Mesa ");
        return text.substr(0, text.find(',')) + " " + (mesa == std::string::npos ? text : text.substr(mesa));
    }

    bool sameDriver() {
        std::ifstream file(kFolder / "driver.txt");
        std::string line;
        return std::getline(file, line) && line == driver();
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, PictureGolden, allBackends(), backendName);

void PictureGolden::check(const std::string& name, const Shot& shot) {
    const fs::path file = kFolder / (name + ".png");
    const Picture actual = draw(shot);
    if (updating()) {
        const Result<void> written = writePng(file, actual);
        EXPECT_TRUE(written) << toString(written.error());
        std::ofstream(kFolder / "driver.txt") << driver() << "\n";
        return;
    }
    ASSERT_TRUE(fs::exists(file)) << "there is no golden " << file << ": see the target update-goldens";
    const Picture expected = readPicture(file);
    const Difference difference = compare(actual, expected, [](int, int) { return true; });
    // Another Mesa may round a pixel otherwise. Between 22.3.6 and 25.0.7 no pixel of any of them differs.
    const bool same = sameDriver();
    if (!same)
        std::cout << name << " by " << driver() << ": " << difference << "\n";
    const bool alike =
        same ? difference.max() == 0 : difference.mean <= 0.02 && difference.shareAbove(1) <= 0.002;
    EXPECT_TRUE(alike) << name << " by " << driver() << ": " << difference << "\n"
                       << writeDifference("picture_" + name, actual, expected);
}

// One picture by two programs: those for any GPU, and what VideoCore IV runs best. By the limits that hold
// between correct renderers.
class PictureForms : public PictureTest {
protected:
    PictureForms() : PictureTest({160, 120}) {}
};

INSTANTIATE_TEST_SUITE_P(Backends, PictureForms, allBackends(), backendName);

TEST_P(PictureForms, OfAPiLookAsThoseOfAnyGpu) {
    for (const PictureRow& row : pictureRows()) {
        const Shot shot = row.make();
        const Picture actual = draw(withForms(shot, Target::Vc4)), expected = draw(shot);
        const Difference difference = compareLit(actual, expected);
        std::cout << row.name << ": " << difference << "\n";
        EXPECT_TRUE(difference.mean <= 0.05 && difference.shareAbove(1) <= 0.001 && difference.max() <= 4)
            << row.name << " in the forms for vc4: " << difference << "\n"
            << writeDifference("picture_" + std::string(row.name) + ".vc4", actual, expected);
    }
}

TEST_P(PictureGolden, ScenesOfOurOwn) {
    for (const PictureRow& row : pictureRows())
        check(row.name, row.make());
}

TEST_P(PictureGolden, TheUrnOfMakeModel) {
    Shot shot = shotOf(kUrn);
    shot.camera = framingCamera(shot.scene.bounds(), 4.0 / 3);
    if (shot.lighting.suns.empty())
        shot.lighting.suns.push_back({.direction = {-0.4f, -0.7f, -0.8f}, .illuminance = 3});
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.3f}};
    check("urn", shot);
}

TEST_P(PictureGolden, AModelByOthers) {
    if (!fs::exists(kEngine))
        GTEST_SKIP() << "needs the Debian package assimp-testmodels";
    Shot shot = shotOf(kEngine);
    shot.camera = framingCamera(shot.scene.bounds(), 4.0 / 3);
    shot.lighting.suns = {{.direction = {-0.4f, -0.7f, -0.8f}, .illuminance = 3}};
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.2f, 0.2f, 0.2f}};
    check("engine", shot);
}

TEST(PictureGoldens, NoFileIsLeftOver) {
    std::set<std::string> known = {"driver.txt", "urn.png", "engine.png"};
    for (const PictureRow& row : pictureRows())
        known.insert(std::string(row.name) + ".png");
    for (const fs::directory_entry& entry : fs::directory_iterator(kFolder))
        EXPECT_TRUE(known.count(entry.path().filename().string()) > 0) << entry.path();
}

} // namespace
} // namespace franken::test
