// SPDX-License-Identifier: MIT
// What the renderer makes of a sky alone, against brute force and against the Khronos sample viewer.
#include "support/draw_scene.h"
#include "support/shapes.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace franken::test {
namespace {

constexpr int kSize = 256;
constexpr double kTanHalfFov = 0.36397023426620234; // Of 20 degrees.

/// The venice sky with all that is made of it, once for all tests.
struct Sky {
    SkyCoefficients coefficients;
    ReflectionMaps reflection;
};

const Sky* venice() {
    static const std::optional<Sky> sky = []() -> std::optional<Sky> {
        const std::filesystem::path file = findShared("assets/env/venice.hdr");
        const Result<Environment> loaded =
            file.empty() ? Error{"test.missing", "", "", ""} : loadEnvironment(file);
        if (!loaded)
            return std::nullopt;
        return Sky{skyCoefficients(*loaded), {filterReflection(*loaded), reflectionLookup()}};
    }();
    return sky ? &*sky : nullptr;
}

void lightBy(const Sky& sky, Shot& shot) {
    shot.lighting.ambient = {.kind = Ambient::Sky, .sky = sky.coefficients};
    shot.lighting.reflection = Reflection::Lookup;
    shot.reflection = sky.reflection;
}

/// A unit sphere before a camera at (0, 0, 4) that looks along -Z.
Shot sphereOf(const glm::vec3& base, float metallic, float roughness) {
    SceneBuilder builder;
    Material material;
    material.factors.baseColor = {base.r, base.g, base.b, 1};
    material.factors.metallic = metallic;
    material.factors.roughness = roughness;
    builder.add(sphere(256), builder.addMaterial(material));
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = {}};
    shot.camera.world = glm::translate(glm::mat4(1), glm::vec3(0, 0, 4));
    shot.camera.yfov = 0.69813170f;
    return shot;
}

/// Whether the pixel's centre sees the sphere at an angle that is not grazing (N.V above 0.05).
bool facesCamera(int x, int y) {
    const double s = (2 * (x + 0.5) / kSize - 1) * kTanHalfFov;
    const double t = (1 - 2 * (y + 0.5) / kSize) * kTanHalfFov;
    const glm::dvec3 ray = glm::normalize(glm::dvec3(s, t, -1)), eye(0, 0, 4);
    const double b = glm::dot(eye, ray), root = b * b - 15;
    return root >= 0 && std::sqrt(root) > 0.05;
}

class SkySpheres : public PictureTest {
protected:
    SkySpheres() : PictureTest({kSize, kSize}) {}

    /// Draws a sphere, which may be so many codes off in the mean.
    void expectNear(const Shot& shot, const std::string& reference, double codes) {
        const Picture actual = draw(shot);
        const Picture expected = readPicture(findShared("reference/sky/" + reference + ".numpy.png"));
        const Difference difference = compare(actual, expected, facesCamera);
        std::cout << reference << ": " << difference << "\n";
        EXPECT_GT(difference.pixels, 20'000u);
        EXPECT_LE(difference.mean, codes) << writeDifference(
            "sky_" + reference + "." + std::string(toString(GetParam())), actual, expected);
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, SkySpheres, allBackends(), backendName);

/// Half of what the split sum of the Khronos viewer leaves there: 4.13, 5.90, 9.54 and 13.2 codes.
TEST_P(SkySpheres, MetalsAreHalfAsFarOffAsTheSplitSum) {
    const Sky* sky = venice();
    if (sky == nullptr || findShared("reference/sky").empty())
        GTEST_SKIP() << "needs ../shared/reference/sky and ../shared/assets/env beside the sources";
    const std::pair<const char*, double> rows[] = {
        {"metal_r0.1", 4.13}, {"metal_r0.4", 5.90}, {"metal_r0.6", 9.54}, {"metal_r1.0", 13.2}};
    for (const auto& [name, splitSum] : rows) {
        Shot shot = sphereOf({0.9f, 0.5f, 0.2f}, 1, std::stof(std::string(name).substr(7)));
        lightBy(*sky, shot);
        expectNear(shot, name, 0.5 * splitSum);
    }
}

/// The split sum leaves 1.6 codes on the dielectric.
TEST_P(SkySpheres, OthersAreAsTheyShouldBe) {
    const Sky* sky = venice();
    if (sky == nullptr || findShared("reference/sky").empty())
        GTEST_SKIP() << "needs ../shared/reference/sky and ../shared/assets/env beside the sources";
    Shot dielectric = sphereOf({0.9f, 0.5f, 0.2f}, 0, 0.2f);
    lightBy(*sky, dielectric);
    expectNear(dielectric, "dielectric_r0.2", 1.6);

    // An albedo of 0.8: without the reflection a dielectric scatters all of its base colour.
    Shot lambert = sphereOf(glm::vec3(0.8f), 0, 1);
    lightBy(*sky, lambert);
    lambert.lighting.reflection = Reflection::None;
    expectNear(lambert, "lambert0.8", 2);

    // The sharpest level holds roughness 0.0625 in texels of half a degree.
    Shot mirror = sphereOf(glm::vec3(1), 1, 0);
    lightBy(*sky, mirror);
    expectNear(mirror, "mirror", 4);
}

/// The errors of a channel around a pixel, 9 x 9; empty where some of them lie outside.
std::vector<int> errorsAround(const Picture& actual, const Picture& expected, const Mask& inside,
                              const glm::ivec2& pixel, std::size_t channel) {
    std::vector<int> errors;
    for (int i = 0; i < 81; ++i) {
        const int x = pixel.x + i % 9 - 4, y = pixel.y + i / 9 - 4;
        if (x < 0 || y < 0 || x >= actual.width || y >= actual.height || !inside(x, y))
            return {};
        const std::size_t at = static_cast<std::size_t>(4 * (y * actual.width + x)) + channel;
        errors.push_back(actual.rgba[at] - expected.rgba[at]);
    }
    return errors;
}

/// The share of pixels whose error is more than 4 codes off the median of the errors around it: spots and
/// contours that the expected picture has not.
double structureOf(const Picture& actual, const Picture& expected, const Mask& inside) {
    std::size_t pixels = 0, apart = 0;
    for (int i = 0; i < actual.width * actual.height; ++i) {
        int most = -1;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            std::vector<int> errors =
                errorsAround(actual, expected, inside, {i % actual.width, i / actual.width}, channel);
            if (errors.empty())
                break;
            const int own = errors[40];
            std::nth_element(errors.begin(), errors.begin() + 40, errors.end());
            most = std::max(most, std::abs(own - errors[40]));
        }
        pixels += most >= 0 ? 1 : 0;
        apart += most > 4 ? 1 : 0;
    }
    EXPECT_GT(pixels, 500u);
    return static_cast<double>(apart) / static_cast<double>(pixels);
}

/// The spheres of ../shared/reference/skies, by the files that stand beside them.
class HardSkySpheres : public PictureTest {
protected:
    HardSkySpheres() : PictureTest({64, 64}) {}

    static bool inside(int x, int y) { return facesCamera(4 * x + 2, 4 * y + 2); }

    void expectNear(const Shot& shot, const std::string& reference, const std::string& how, double codes) {
        const Picture actual = draw(shot);
        const Picture expected = readPicture(findShared("reference/skies/" + reference + ".png"));
        const Difference difference = compare(actual, expected, inside);
        const std::string title = reference + how;
        std::cout << title << ": " << difference << "\n";
        EXPECT_GT(difference.pixels, 1'000u);
        EXPECT_LE(difference.mean, codes)
            << writeDifference("sky_" + title + "." + std::string(toString(GetParam())), actual, expected);
        if (how == kLambert) {
            EXPECT_LE(structureOf(actual, expected, inside), 0.001) << title;
        }
    }

    static constexpr const char* kLambert = ".as_lambert";
};

INSTANTIATE_TEST_SUITE_P(Backends, HardSkySpheres, allBackends(), backendName);

/// The file's sphere, lit by that sky.
Shot litSphere(const Sky& sky, const std::string& material) {
    Shot shot = shotOf(findShared("reference/spheres/sky_" + material + ".gltf"));
    lightBy(sky, shot);
    return shot;
}

/// A Lambert surface of albedo 0.8, drawn with the reflection: nothing is reflected, and 0.96 scattered.
Shot lambertSphere(const Sky& sky) {
    Shot shot = sphereOf(glm::vec3(0.8f / kDielectricScatters), 0, 1);
    lightBy(sky, shot);
    for (std::size_t i = 0; i < shot.reflection->lookup.rgba.size(); ++i)
        if (i % 4 < 2)
            shot.reflection->lookup.rgba[i] = 0;
    return shot;
}

/// The goal of metals is 2.5 codes, or half of what the plain split sum leaves, which sky_numbers_test
/// computes and prints; of coefficients alone 5 codes. Where a row has more, the goal is out of reach of one
/// lookup of a round lobe, or of any nine coefficients (generator/docs/sky.md): the bound then is what is
/// reached.
TEST_P(HardSkySpheres, AreAsTheyShouldBe) {
    struct Row {
        const char* sky;
        double coefficients;
        double metals[3]; ///< Roughness 0.2, 0.6 and 1: the most codes.
    };
    for (const Row& row : {Row{"softbox", 5, {3.7, 6.6, 8}}, Row{"half", 5, {2.5, 4.6, 5.9}},
                           Row{"studio", 16.6, {5.3, 8.5, 9.6}}, Row{"sunset", 5, {2.5, 5, 7.2}}}) {
        const std::string name = row.sky;
        const std::filesystem::path file = findShared("reference/skies/" + name + ".hdr");
        if (file.empty())
            GTEST_SKIP() << "needs ../shared/reference/skies beside the sources";
        const auto loaded = loadEnvironment(file);
        ASSERT_TRUE(loaded);
        const Sky sky{skyCoefficients(*loaded), {filterReflection(*loaded), reflectionLookup()}};
        expectNear(lambertSphere(sky), name + ".lambert0.8", kLambert, 1);
        // The file's own material is a dielectric of roughness 1, whose truth is up to 1.5 codes off the
        // picture.
        expectNear(litSphere(sky, "lambert0.8"), name + ".lambert0.8", "", 1.5);
        Shot matt = litSphere(sky, "lambert0.8");
        matt.lighting.reflection = Reflection::None;
        expectNear(matt, name + ".lambert0.8", ".sh", row.coefficients);
        for (const std::string dielectric : {"dielectric_r0.2", "dielectric_r0.6"})
            expectNear(litSphere(sky, dielectric), name + "." + dielectric, "", 2.5);
        const std::string metals[] = {"metal_r0.2", "metal_r0.6", "metal_r1.0"};
        for (int i = 0; i < 3; ++i)
            expectNear(litSphere(sky, metals[i]), name + "." + metals[i], "", row.metals[i]);
    }
}

class SkyModel : public PictureTest {
protected:
    SkyModel() : PictureTest({512, 512}) {}
};

INSTANTIATE_TEST_SUITE_P(Backends, SkyModel, allBackends(), backendName);

/// That viewer adds what is scattered between microfacets several times, as Look::energy does, and a Fresnel
/// term that depends on roughness.
TEST_P(SkyModel, WaterBottleLooksAsInTheKhronosViewer) {
    const Sky* sky = venice();
    const std::filesystem::path model = findShared("reference/scenes/WaterBottle/WaterBottle.gltf");
    if (sky == nullptr || model.empty())
        GTEST_SKIP() << "needs ../shared/reference and ../shared/assets/env beside the sources";
    Shot shot = shotOf(model);
    lightBy(*sky, shot);
    for (const std::string name : {"WaterBottle.ibl_sun", "WaterBottle.ibl"}) {
        const Picture expected = readPicture(findShared("reference/sky/" + name + ".khronos.png"));
        for (const bool energy : {false, true}) {
            shot.look.energy = energy;
            const Picture actual = draw(shot);
            const Difference difference = compareLit(actual, expected);
            std::cout << name << (energy ? " with energy: " : ": ") << difference << "\n";
            // Found: 4.6 and 5.2, with energy 4.5 and 4.8. That viewer's split sum is 4 to 13 codes off brute
            // force (generator/docs/sky.md).
            EXPECT_LE(difference.mean, energy ? 5 : 5.4)
                << writeDifference(name + "." + std::string(toString(GetParam())), actual, expected);
        }
        shot.lighting.suns.clear();
    }
}

} // namespace
} // namespace franken::test
