// SPDX-License-Identifier: MIT
// A lit sphere against three renderers by others: float64 with both BRDFs, and the Khronos sample viewer.
#include "support/draw_scene.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace franken::test {
namespace {

constexpr int kSize = 256;

struct Reference {
    Brdf brdf;
    std::vector<std::string> pictures;
};

const Reference kReferences[] = {{Brdf::Gltf, {"glTF", "khronos"}}, {Brdf::Seed, {"seed"}}};
const std::string kNames[] = {"m0_r0.1", "m0_r0.3", "m0_r0.8", "m1_r0.1", "m1_r0.3", "m1_r0.8"};

// The camera of these files is at (0, 0, 4), looks along -Z, and sees 40 degrees.
// Whether the middle of a pixel hits the unit sphere at N.V above 0.05: away from the silhouette.
bool facesCamera(int x, int y) {
    const double half = std::tan(0.5 * glm::radians(40.0));
    const glm::dvec3 ray = glm::normalize(
        glm::dvec3(half * ((x + 0.5) / (kSize / 2.0) - 1), half * (1 - (y + 0.5) / (kSize / 2.0)), -1));
    const glm::dvec3 eye(0, 0, 4);
    const double b = glm::dot(eye, ray);
    const double root = b * b - (glm::dot(eye, eye) - 1);
    if (root < 0)
        return false;
    const glm::dvec3 normal = eye + ray * (-b - std::sqrt(root));
    return glm::dot(normal, -ray) > 0.05;
}

// Found to hold between correct renderers. The two BRDFs are 4 to 8 codes apart in the mean.
bool alike(const Difference& difference) {
    return difference.mean <= 0.05 && difference.shareAbove(1) <= 0.001 && difference.max() <= 4;
}

class Sphere : public PictureTest {
protected:
    Sphere() : PictureTest({kSize, kSize}) {}

    /// With the picture `title`.png.
    void compareWith(const std::filesystem::path& folder, const std::string& title, const Picture& actual);
};

INSTANTIATE_TEST_SUITE_P(Backends, Sphere, allBackends(), backendName);

void Sphere::compareWith(const std::filesystem::path& folder, const std::string& title,
                         const Picture& actual) {
    const Picture expected = readPicture(folder / (title + ".png"));
    const Difference difference = compare(actual, expected, facesCamera);
    EXPECT_GT(difference.pixels, 20'000u);
    EXPECT_TRUE(alike(difference)) << title << ": " << difference << "\n"
                                   << writeDifference(title + "." + std::string(toString(GetParam())), actual,
                                                      expected);
}

TEST_P(Sphere, LooksAsOthersDrawIt) {
    const std::filesystem::path folder = findShared("reference/spheres");
    if (folder.empty())
        GTEST_SKIP() << "needs ../shared/reference/spheres beside the sources";
    for (const std::string& name : kNames) {
        Shot shot = shotOf(folder / ("sphere_" + name + ".gltf"));
        for (const auto& [brdf, pictures] : kReferences) {
            shot.look.brdf = brdf;
            for (const Target target : kForms) {
                const Picture actual = draw(withForms(shot, target));
                for (const std::string& picture : pictures)
                    compareWith(folder, "sphere_" + name + "." + picture, actual);
            }
        }
    }
}

TEST_P(Sphere, OneBrdfIsNotTakenForTheOther) {
    const std::filesystem::path folder = findShared("reference/spheres");
    if (folder.empty())
        GTEST_SKIP() << "needs ../shared/reference/spheres beside the sources";
    const Picture seed = readPicture(folder / "sphere_m1_r0.8.seed.png");
    const Difference difference = compare(draw(shotOf(folder / "sphere_m1_r0.8.gltf")), seed, facesCamera);
    EXPECT_GT(difference.mean, 2) << difference;
}

} // namespace
} // namespace franken::test
