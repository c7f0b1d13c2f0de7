// SPDX-License-Identifier: MIT
// What the renderer makes of a sky alone, against brute force and against the Khronos sample viewer.
#include "support/draw_scene.h"
#include "support/shapes.h"

#include <glm/ext/matrix_transform.hpp>

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
    shot.lighting.ambient = Ambient::Sky;
    shot.lighting.sky = sky.coefficients;
    shot.lighting.reflection = Reflection::Lookup;
    shot.reflection = sky.reflection;
}

/// A unit sphere before a camera at (0, 0, 4) that looks along -Z.
Shot sphereOf(const glm::vec3& base, float metallic, float roughness) {
    SceneBuilder builder;
    Material material;
    material.baseColor = glm::vec4(base, 1);
    material.metallic = metallic;
    material.roughness = roughness;
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

    // An albedo of 0.8: what a dielectric scatters is 0.96 of its base colour.
    Shot lambert = sphereOf(glm::vec3(0.8f / 0.96f), 0, 1);
    lightBy(*sky, lambert);
    lambert.lighting.reflection = Reflection::None;
    expectNear(lambert, "lambert0.8", 2);

    // The sharpest level holds roughness 0.0625 in texels of half a degree.
    Shot mirror = sphereOf(glm::vec3(1), 1, 0);
    lightBy(*sky, mirror);
    expectNear(mirror, "mirror", 4);
}

/// The spheres of ../shared/reference/skies, by the files that stand beside them.
class HardSkySpheres : public PictureTest {
protected:
    HardSkySpheres() : PictureTest({64, 64}) {}

    static bool inside(int x, int y) { return facesCamera(4 * x + 2, 4 * y + 2); }

    Difference differenceOf(const Sky& sky, const std::string& name, const std::string& material,
                            Reflection specular) {
        Shot shot = shotOf(findShared("reference/spheres/sky_" + material + ".gltf"));
        lightBy(sky, shot);
        shot.lighting.reflection = specular;
        const Picture actual = draw(shot);
        const Picture expected = readPicture(findShared("reference/skies/" + name + "." + material + ".png"));
        const Difference difference = compare(actual, expected, inside);
        std::cout << name << "." << material << (specular == Reflection::None ? " (sh)" : "") << ": "
                  << difference << "\n";
        EXPECT_GT(difference.pixels, 1'000u);
        return difference;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, HardSkySpheres, allBackends(), backendName);

/// Metals: half of the plain split sum, which sky_data_test computes and prints, or 2.5 codes. At roughness
/// 0.2 one lookup of a round lobe is only closer than the split sum where lamps have edges. The file of the
/// Lambert sphere is a dielectric, which reflects a little and scatters 0.96 of its base: the rest up to 1.5.
/// A dark half under a lamp is what nine coefficients show worst.
TEST_P(HardSkySpheres, AreAsTheyShouldBe) {
    struct Row {
        const char* sky;
        double coefficients;
        double metals[3]; ///< Roughness 0.2, 0.6 and 1: the most codes.
    };
    for (const Row& row : {Row{"softbox", 5.5, {4.2, 6.6, 8}}, Row{"half", 5, {2.5, 4.6, 5.9}},
                           Row{"studio", 17.5, {6.4, 8.5, 9.6}}, Row{"sunset", 5, {2.5, 5, 7.2}}}) {
        const std::filesystem::path file = findShared("reference/skies/" + std::string(row.sky) + ".hdr");
        if (file.empty())
            GTEST_SKIP() << "needs ../shared/reference/skies beside the sources";
        const auto loaded = loadEnvironment(file);
        ASSERT_TRUE(loaded);
        const Sky sky{skyCoefficients(*loaded), {filterReflection(*loaded), reflectionLookup()}};
        EXPECT_LE(differenceOf(sky, row.sky, "lambert0.8", Reflection::Lookup).mean, 1.5);
        EXPECT_LE(differenceOf(sky, row.sky, "lambert0.8", Reflection::None).mean, row.coefficients);
        for (const char* dielectric : {"dielectric_r0.2", "dielectric_r0.6"})
            EXPECT_LE(differenceOf(sky, row.sky, dielectric, Reflection::Lookup).mean, 2.5);
        const char* const metals[] = {"metal_r0.2", "metal_r0.6", "metal_r1.0"};
        for (int i = 0; i < 3; ++i)
            EXPECT_LE(differenceOf(sky, row.sky, metals[i], Reflection::Lookup).mean, row.metals[i]);
    }
}

class SkyModel : public PictureTest {
protected:
    SkyModel() : PictureTest({512, 512}) {}
};

INSTANTIATE_TEST_SUITE_P(Backends, SkyModel, allBackends(), backendName);

/// That viewer adds what is scattered between microfacets several times, and a Fresnel term that depends on
/// roughness, so its rough metals are a little brighter.
TEST_P(SkyModel, WaterBottleLooksAsInTheKhronosViewer) {
    const Sky* sky = venice();
    const std::filesystem::path model = findShared("reference/scenes/WaterBottle/WaterBottle.gltf");
    if (sky == nullptr || model.empty())
        GTEST_SKIP() << "needs ../shared/reference and ../shared/assets/env beside the sources";
    Shot shot = shotOf(model);
    lightBy(*sky, shot);
    for (const std::string name : {"WaterBottle.ibl_sun", "WaterBottle.ibl"}) {
        const Picture expected = readPicture(findShared("reference/sky/" + name + ".khronos.png"));
        const Picture actual = draw(shot);
        const Difference difference = compareLit(actual, expected);
        std::cout << name << ": " << difference << "\n";
        EXPECT_LE(difference.mean, 8)
            << writeDifference(name + "." + std::string(toString(GetParam())), actual, expected);
        shot.lighting.suns.clear();
    }
}

} // namespace
} // namespace franken::test
