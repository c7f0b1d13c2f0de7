// SPDX-License-Identifier: MIT
// What rough surfaces scatter between their facets: programs on single points, in floats, against numbers by
// others and against what must come out; and pictures of a white metal under a white sky.
#include "numbers.h"

#include "franken/gl_object.h"
#include "support/point_shader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace franken::test {
namespace {

/// A row of the reference: the share of a white sky's light that is reflected.
struct Albedo {
    float roughness, nDotV, f0;
    double share, once, turquin; ///< E, of F0 = 1; of this F0 after one reflection; and after all.
};

std::vector<Albedo> readAlbedos(const std::filesystem::path& file) {
    std::vector<Albedo> albedos;
    std::ifstream in(file);
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        Albedo row{};
        double skipped = 0; // A, B, E_avg, and what others take for all reflections.
        numbers >> row.roughness >> row.nDotV >> row.f0 >> skipped >> skipped >> row.share >> skipped >>
            row.once;
        numbers >> skipped >> skipped >> skipped >> skipped >> row.turquin;
        EXPECT_TRUE(numbers) << line;
        albedos.push_back(row);
    }
    return albedos;
}

struct Form {
    Brdf brdf;
    MetallicRoughness source;
    Target target;
};

std::vector<Form> allForms() {
    std::vector<Form> forms;
    for (const Brdf brdf : {Brdf::Gltf, Brdf::Fast, Brdf::Schlick})
        for (const MetallicRoughness source : {MetallicRoughness::Factors, MetallicRoughness::Packed})
            for (const Target target : kForms)
                forms.push_back({brdf, source, target});
    return forms;
}

/// One sun, linear output. Textures are white, so that factors are what they are multiplied with.
Permutation permutationFor(const Form& form, bool energy) {
    Permutation permutation;
    permutation.suns = 1;
    permutation.brdf = form.brdf;
    permutation.energy = energy;
    permutation.metallicRoughness = form.source;
    permutation.target = form.target;
    permutation.output = Output::Linear;
    return canonicalise(permutation)->permutation;
}

Float3 towards(float cosine, float turn) {
    const float sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

ShadedPoint pointOf(const Float3& toCamera, const Float3& toLight, float metallic, float f0, float roughness,
                    Brdf brdf) {
    MaterialFactors factors;
    factors.baseColor = {f0, f0, f0, 1};
    factors.metallic = metallic;
    factors.roughness = roughness;
    return pointAt(toCamera, toLight, factors, brdf);
}

class EnergyTest : public OffscreenTest {
protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        if (IsSkipped() || HasFatalFailure())
            return;
        m_white = GlTexture(gl(), generate(gl().GenTextures));
        constexpr std::uint8_t kWhite[] = {255, 255, 255, 255};
        gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(rowOf(TextureRole::MetallicRoughness).unit));
        gl().BindTexture(GL_TEXTURE_2D, m_white.name());
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhite);
    }

    /// How many times brighter each point is than after one reflection.
    std::vector<double> gains(const Form& form, const std::vector<ShadedPoint>& points) {
        const auto all = shade(gl(), permutationFor(form, true), points);
        const auto once = shade(gl(), permutationFor(form, false), points);
        std::vector<double> result;
        for (std::size_t i = 0; i < all.size() && i < once.size(); ++i)
            result.push_back(double{all[i][0]} / double{once[i][0]});
        return result;
    }

private:
    GlTexture m_white;
};

INSTANTIATE_TEST_SUITE_P(Backends, EnergyTest, allBackends(), backendName);

// Under any sun a metal must be as many times brighter as it is under a sky. No point of the reference was in
// the fit (generator/docs/energy_fit.py).
TEST_P(EnergyTest, MetalsAreAsBrightAsTurquinsUnderAWhiteSky) {
    const std::filesystem::path file = findShared("reference/energy/albedo.csv");
    if (file.empty())
        GTEST_SKIP() << "needs ../shared/reference/energy/albedo.csv beside the sources";
    const std::vector<Albedo> albedos = readAlbedos(file);
    ASSERT_GE(albedos.size(), 400u);
    for (const Form& form : allForms()) {
        std::vector<ShadedPoint> points;
        for (const Albedo& row : albedos)
            points.push_back(
                pointOf(towards(row.nDotV, 0), towards(0.7f, 2.5f), 1, row.f0, row.roughness, form.brdf));
        const std::vector<double> found = gains(form, points);
        ASSERT_EQ(found.size(), albedos.size());
        double worst = 0, worstWhite = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const double light = albedos[i].once * found[i];
            worst = std::max(worst, std::abs(light / albedos[i].turquin - 1));
            if (albedos[i].f0 == 1)
                worstWhite = std::max(worstWhite, std::abs(light - 1));
        }
        std::cout << toName(permutationFor(form, true)) << ": worst " << 100 * worst << " %, white "
                  << 100 * worstWhite << " %\n";
        EXPECT_LE(worst, 0.02);
        EXPECT_LE(worstWhite, 0.01);
    }
}

// glTF mixes a metal and a dielectric, each with its own gain: that of F0 = 0.04 alone where there is no
// metal.
TEST_P(EnergyTest, DielectricsHaveTheGainOfTheirOwnReflectance) {
    for (const Form& form : allForms()) {
        std::vector<ShadedPoint> points;
        std::vector<double> expected;
        for (const float roughness : {0.3f, 0.6f, 1.0f})
            for (const float nDotV : {0.1f, 0.5f, 1.0f}) {
                points.push_back(pointOf(towards(nDotV, 0), towards(0.7f, 2.5f), 0, 0, roughness, form.brdf));
                expected.push_back(1 + 0.04 * double{energyCompensation(nDotV, roughness)});
            }
        const std::vector<double> found = gains(form, points);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], expected[i], 0.002) << toName(permutationFor(form, true)) << ", " << i;
    }
}

// A furnace: suns from everywhere, summed by the midpoint rule. Nothing is looked up in a reference.
TEST_P(EnergyTest, AWhiteMetalGivesAllLightOfManySunsBack) {
    constexpr int kRings = 48, kTurns = 48;
    for (const Form& form : allForms()) {
        if (form.brdf != Brdf::Gltf) // The fit is to its shadowing.
            continue;
        for (const auto& [roughness, nDotV] :
             {std::pair(0.4f, 0.9f), {0.6f, 0.5f}, {0.8f, 0.2f}, {1.0f, 0.8f}}) {
            std::vector<ShadedPoint> points;
            for (int ring = 0; ring < kRings; ++ring)
                for (int turn = 0; turn < kTurns; ++turn)
                    points.push_back(pointOf(
                        towards(nDotV, 0),
                        towards((static_cast<float>(ring) + 0.5f) / kRings,
                                (static_cast<float>(turn) + 0.5f) * std::numbers::pi_v<float> / kTurns),
                        1, 1, roughness, form.brdf));
            double light = 0; // Of each: pi times the BRDF times N.L; half the turn stands for all of it.
            for (const auto& color : shade(gl(), permutationFor(form, true), points))
                light += 2 * double{color[0]} / (kRings * kTurns);
            EXPECT_NEAR(light, 1, 0.015) << roughness << ", " << toName(permutationFor(form, true));
        }
    }
}

using EnergyPicture = PictureTest;
INSTANTIATE_TEST_SUITE_P(Backends, EnergyPicture, allBackends(), backendName);

/// A ball under a sky of one radiance, with the library's own lookup.
Shot underAWhiteSky(float metallic, float roughness, bool textured) {
    static const Image lookup = reflectionLookup();
    SceneBuilder builder;
    Material material;
    material.factors.metallic = metallic;
    material.factors.roughness = roughness;
    if (textured)
        material.textures[TextureRole::MetallicRoughness].texture = builder.addTexture(texel(255, 255, 255));
    builder.add(sphere(32), builder.addMaterial(material));
    Shot shot = filledBy(builder);
    shot.lighting.ambient.kind = Ambient::Sky;
    shot.lighting.reflection = Reflection::Lookup;
    shot.reflection = ReflectionMaps{{texel(255, 255, 255, 255), 0.75f}, lookup};
    return shot;
}

struct Share {
    double mean = 0;
    int least = 255, most = 0, count = 0;
};

/// Of the sky's light, of the pixels that the ball covers whole.
Share shareOf(const Picture& picture) {
    Share share;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double dx = 2 * (x + 0.5) / picture.width - 1, dy = 2 * (y + 0.5) / picture.height - 1;
            if (dx * dx + dy * dy > 0.95 * 0.95)
                continue;
            const int code = codesAt(picture, x, y)[0];
            share.least = std::min(share.least, code);
            share.most = std::max(share.most, code);
            share.mean += code / (0.75 * 255);
            ++share.count;
        }
    share.mean /= share.count;
    return share;
}

TEST_P(EnergyPicture, AWhiteMetalVanishesInAWhiteFurnace) {
    for (const bool textured : {false, true})
        for (const float roughness : {0.2f, 0.6f, 0.8f, 1.0f}) {
            Shot shot = underAWhiteSky(1, roughness, textured);
            const Share once = shareOf(draw(shot));
            shot.look.energy = true;
            const Share all = shareOf(draw(shot));
            std::cout << "roughness " << roughness << ": " << 100 * once.mean << " % -> " << 100 * all.mean
                      << " %\n";
            EXPECT_GT(all.count, 1000);
            EXPECT_NEAR(all.mean, 1, 0.01);
            EXPECT_GE(all.least, 0.99 * 0.75 * 255 - 0.5);
            EXPECT_LE(all.most, 1.01 * 0.75 * 255 + 0.5);
            if (roughness == 1) {
                EXPECT_LT(once.mean, 0.5);
            }
        }
}

// The compensation of lights comes from the lookup beside a sky, and from a fit without one: a sun must add
// the same.
TEST_P(EnergyPicture, ASunAddsAsMuchBesideASkyAsAlone) {
    for (const bool textured : {false, true})
        for (const float roughness : {0.5f, 1.0f}) {
            Shot sky = underAWhiteSky(0.7f, roughness, textured);
            sky.look.energy = true;
            sky.lighting.exposure = 0.3f;
            Shot both = sky, sun = sky;
            both.lighting.suns = {{.direction = {0, 0, -1}, .illuminance = 1}};
            sun.lighting = both.lighting;
            sun.lighting.ambient = {};
            sun.lighting.reflection = Reflection::None;
            const Picture ofSky = draw(sky), ofSun = draw(sun), ofBoth = draw(both);
            for (int x = ofBoth.width / 8; x < ofBoth.width; x += ofBoth.width / 8) {
                const int y = ofBoth.height / 2;
                ASSERT_LT(codesAt(ofBoth, x, y)[0], 255);
                EXPECT_NEAR(codesAt(ofBoth, x, y)[0], codesAt(ofSky, x, y)[0] + codesAt(ofSun, x, y)[0], 2)
                    << roughness << ", " << textured << ", " << x;
            }
        }
}

// A renderer that has no sky yet must not give back what no texture says.
TEST_P(EnergyPicture, WithoutTheSkysTexturesASunIsNoBrighter) {
    Shot shot = underAWhiteSky(1, 1, false);
    shot.lighting.suns = {{.direction = {0, 0, -1}, .illuminance = std::numbers::pi_v<float>}};
    shot.reflection.reset();
    const std::array<int, 3> once = codesOf(draw(shot));
    shot.look.energy = true;
    EXPECT_EQ(codesOf(draw(shot)), once);
}

} // namespace
} // namespace franken::test
