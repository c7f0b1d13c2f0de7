// SPDX-License-Identifier: MIT
// The BRDF snippets on single points, in floats, against double precision: numbers by others, and our own.
#include "franken/gl_object.h"
#include "support/brdf_reference.h"
#include "support/draw_scene.h"
#include "support/point_shader.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

namespace franken::test {
namespace {

struct Sample {
    LitPoint point;
    glm::dvec3 gltf{0}, seed{0};
};

std::vector<Sample> readSamples(const std::filesystem::path& file) {
    std::vector<Sample> samples;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#' || line[0] == 'v')
            continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        const auto read3 = [&](glm::dvec3& v) { numbers >> v.x >> v.y >> v.z; };
        Sample sample;
        read3(sample.point.toCamera);
        read3(sample.point.toLight);
        read3(sample.point.baseColor);
        numbers >> sample.point.metallic >> sample.point.roughness;
        read3(sample.gltf);
        read3(sample.seed);
        samples.push_back(sample);
    }
    return samples;
}

Float3 toFloat3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

ShadedPoint toPoint(const LitPoint& lit, Brdf brdf) {
    MaterialFactors factors;
    const Float3 base = toFloat3(lit.baseColor);
    factors.baseColor = {base[0], base[1], base[2], 1};
    factors.metallic = static_cast<float>(lit.metallic);
    factors.roughness = static_cast<float>(lit.roughness);
    ShadedPoint point = pointAt(toFloat3(lit.toCamera), toFloat3(lit.toLight), factors, brdf);
    point.normal = toFloat3(lit.normal);
    return point;
}

/// One sun, linear output. Textures are white, so that factors are what they are multiplied with.
Permutation permutationFor(Brdf brdf, MetallicRoughness source, Target target = Target::Generic) {
    Permutation permutation;
    permutation.suns = 1;
    permutation.brdf = brdf;
    permutation.metallicRoughness = source;
    permutation.target = target;
    permutation.output = Output::Linear;
    return canonicalise(permutation)->permutation;
}

constexpr std::pair<MetallicRoughness, Target> kSourcesAndForms[] = {
    {MetallicRoughness::Factors, Target::Generic},
    {MetallicRoughness::Packed, Target::Generic},
    {MetallicRoughness::Factors, Target::Vc4},
    {MetallicRoughness::Packed, Target::Vc4}};

constexpr Brdf kBrdfs[] = {Brdf::Gltf, Brdf::Seed, Brdf::Fast, Brdf::Schlick};

/// Relative to the radiance, or to 0.05 where it is below.
struct Errors {
    double worst = 0;
    int count = 0, many = 0; ///< Numbers, and those off by more than 1 %.

    void add(double actual, double expected) {
        EXPECT_TRUE(std::isfinite(actual));
        const double error = std::abs(actual - expected) / std::max(expected, 0.05);
        worst = std::max(worst, error);
        ++count;
        many += error > 0.01 ? 1 : 0;
    }
};

class BrdfTest : public OffscreenTest {
protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        if (IsSkipped() || HasFatalFailure())
            return;
        m_white = GlTexture(gl(), generate(gl().GenTextures));
        constexpr std::uint8_t kWhite[] = {255, 255, 255, 255};
        gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(samplerUnit("uMetallicRoughnessTexture")));
        gl().BindTexture(GL_TEXTURE_2D, m_white.name());
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kWhite);
    }

    /// Over all points, both sources of roughness, and all forms.
    template<typename Expected>
    Errors errorsOf(const std::vector<LitPoint>& points, Brdf brdf, Expected expected);

private:
    GlTexture m_white;
};

INSTANTIATE_TEST_SUITE_P(Backends, BrdfTest, allBackends(), backendName);

template<typename Expected>
Errors BrdfTest::errorsOf(const std::vector<LitPoint>& points, Brdf brdf, Expected expected) {
    std::vector<ShadedPoint> shaded;
    for (const LitPoint& point : points)
        shaded.push_back(toPoint(point, brdf));
    Errors errors;
    for (const auto& [source, target] : kSourcesAndForms) {
        const auto actual = shade(gl(), permutationFor(brdf, source, target), shaded);
        for (std::size_t i = 0; i < actual.size(); ++i)
            for (int channel = 0; channel < 3; ++channel)
                errors.add(actual[i][static_cast<std::size_t>(channel)], expected(i)[channel]);
    }
    std::cout << "BRDF " << static_cast<int>(brdf) << ": worst " << 100 * errors.worst
              << " %, above 1 %: " << errors.many << " of " << errors.count << "\n";
    return errors;
}

TEST_P(BrdfTest, AgreesWithNumbersByOthers) {
    const std::filesystem::path file = findShared("reference/brdf_samples.csv");
    if (file.empty())
        GTEST_SKIP() << "needs ../shared/reference/brdf_samples.csv beside the sources";
    const std::vector<Sample> samples = readSamples(file);
    ASSERT_EQ(samples.size(), 1500u);
    std::vector<LitPoint> points;
    for (const Sample& sample : samples)
        points.push_back(sample.point);
    // 2e-6 keeps |V+L|^2 off 0: it weighs where the view and the light both graze a smooth surface.
    const Errors gltf = errorsOf(points, Brdf::Gltf, [&](std::size_t i) { return samples[i].gltf; });
    EXPECT_TRUE(gltf.worst <= 0.1 && gltf.many <= gltf.count / 500);
    const Errors seed = errorsOf(points, Brdf::Seed, [&](std::size_t i) { return samples[i].seed; });
    EXPECT_TRUE(seed.worst <= 0.1 && seed.many <= seed.count / 500);
    // Our own reference is held against the same numbers, before it serves for what others have not computed.
    for (const Sample& sample : samples) {
        EXPECT_LE(glm::distance(radianceOf(sample.point, Brdf::Gltf), sample.gltf),
                  1e-6 * (1 + glm::length(sample.gltf)));
        EXPECT_LE(glm::distance(radianceOf(sample.point, Brdf::Seed), sample.seed),
                  1e-6 * (1 + glm::length(sample.seed)));
    }
}

/// Uniform over the hemisphere of +Z, but for the last degrees.
glm::dvec3 randomDirection(std::mt19937& random) {
    std::uniform_real_distribution<double> height(0.02, 1), turn(0, 6.283185307);
    const double z = height(random), angle = turn(random), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

TEST_P(BrdfTest, AgreesWithDoublePrecision) {
    std::mt19937 random(20);
    std::uniform_real_distribution<double> unit(0, 1), roughness(0.1, 1);
    std::vector<LitPoint> points(2000);
    for (LitPoint& point : points) {
        point.toCamera = randomDirection(random);
        point.toLight = randomDirection(random);
        point.baseColor = {unit(random), unit(random), unit(random)};
        point.metallic = unit(random);
        point.roughness = roughness(random);
    }
    for (const Brdf brdf : kBrdfs) {
        const Errors errors =
            errorsOf(points, brdf, [&](std::size_t i) { return radianceOf(points[i], brdf); });
        EXPECT_LE(errors.worst, 0.005);
    }
}

// Rounding may leave a trace of less than nothing.
bool isLight(float value) { return std::isfinite(value) && value >= -1e-6f; }

struct Edge {
    const char* name;
    LitPoint point;
};

const glm::dvec3 kGrazing = glm::normalize(glm::dvec3(1, 0, 1e-4));

// Where a formula divides by zero or takes the root of less than nothing, unless it was written not to.
const Edge kEdges[] = {
    {"rough, straight on", {.roughness = 1}},
    {"a mirror, straight on", {.roughness = 0}},
    {"a black mirror", {.baseColor = {0, 0, 0}, .metallic = 1, .roughness = 0}},
    {"a mirror that reflects the sun elsewhere", {.toLight = {0.6, 0, 0.8}, .metallic = 1, .roughness = 0}},
    {"seen edge-on", {.toCamera = {1, 0, 0}, .roughness = 0.5}},
    {"seen edge-on, a mirror", {.toCamera = {1, 0, 0}, .toLight = {-1, 0, 0}, .roughness = 0}},
    {"lit edge-on", {.toLight = {1, 0, 0}, .roughness = 0.5}},
    {"grazing both ways", {.toCamera = kGrazing, .toLight = {-kGrazing.x, 0, kGrazing.z}, .roughness = 0}},
    {"lit from behind", {.toLight = {0, 0, -1}, .roughness = 1}},
    {"lit from straight behind at a slant", {.toCamera = {0.6, 0, 0.8}, .toLight = {-0.6, 0, -0.8}}},
    {"seen from behind", {.toCamera = {0, 0, -1}}},
    {"seen and lit from behind", {.toCamera = {0, 0, -1}, .toLight = {0, 0, -1}, .roughness = 0}},
    {"black", {.baseColor = {0, 0, 0}}},
};

TEST_P(BrdfTest, IsANumberEverywhere) {
    for (const Brdf brdf : kBrdfs)
        for (const auto& [source, target] : kSourcesAndForms) {
            std::vector<ShadedPoint> points;
            for (const Edge& edge : kEdges)
                points.push_back(toPoint(edge.point, brdf));
            const auto shaded = shade(gl(), permutationFor(brdf, source, target), points);
            ASSERT_EQ(shaded.size(), std::size(kEdges));
            for (std::size_t i = 0; i < shaded.size(); ++i)
                for (const float value : shaded[i])
                    EXPECT_TRUE(isLight(value))
                        << kEdges[i].name << ", BRDF " << static_cast<int>(brdf) << ": " << value;
        }
}

// The peak of a smooth lobe is a quotient of differences of near equals: it must stay a number however they
// round.
TEST_P(BrdfTest, MirrorsAreNumbersAroundTheirPeak) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> roughness(0, 0.05), offset(-1e-3, 1e-3), height(0.001, 1);
    std::vector<LitPoint> points(4000);
    for (LitPoint& point : points) {
        const double z = height(random), x = std::sqrt(1 - z * z);
        point.toCamera = {x, 0, z};
        point.toLight = glm::normalize(glm::dvec3(-x + offset(random), offset(random), z));
        point.roughness = roughness(random);
        point.metallic = 1;
    }
    for (const Brdf brdf : kBrdfs) {
        std::vector<ShadedPoint> shaded;
        for (const LitPoint& point : points)
            shaded.push_back(toPoint(point, brdf));
        for (const Target target : kForms)
            for (const auto& color :
                 shade(gl(), permutationFor(brdf, MetallicRoughness::Factors, target), shaded))
                EXPECT_TRUE(isLight(color[0])) << color[0];
    }
}

TEST_P(BrdfTest, NothingShinesOnABackSide) {
    const auto behind = toPoint({.toLight = glm::normalize(glm::dvec3(0.5, 0, -0.5))}, Brdf::Gltf);
    const auto shaded = shade(gl(), permutationFor(Brdf::Gltf, MetallicRoughness::Factors), {behind});
    ASSERT_EQ(shaded.size(), 1u);
    EXPECT_EQ(shaded[0], (std::array<float, 4>{0, 0, 0, 1}));
}

/// A normal map whose texel is `texel`, on a point with a tangent; lit by one sun.
class NormalMapTest : public BrdfTest {
protected:
    std::array<float, 4> shadeMapped(std::array<std::uint8_t, 4> texel, const Float4& tangent,
                                     const glm::dvec3& toLight) {
        const GlTexture map(gl(), generate(gl().GenTextures));
        gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(samplerUnit("uNormalTexture")));
        gl().BindTexture(GL_TEXTURE_2D, map.name());
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
        ShadedPoint point = toPoint({.toLight = toLight}, Brdf::Gltf);
        point.tangent = tangent;
        Permutation permutation = permutationFor(Brdf::Gltf, MetallicRoughness::Factors);
        permutation.normal = Normal::Map;
        const auto shaded = shade(gl(), permutation, {point});
        return shaded.empty() ? std::array<float, 4>{} : shaded[0];
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, NormalMapTest, allBackends(), backendName);

TEST_P(NormalMapTest, ATangentWithoutLengthIsANumber) {
    for (const float value : shadeMapped({200, 128, 200, 255}, {0, 0, 0, 1}, {0, 0, 1}))
        EXPECT_TRUE(std::isfinite(value));
}

TEST_P(NormalMapTest, AMirroredTangentTurnsTheBitangentRound) {
    const glm::dvec3 fromTop = glm::normalize(glm::dvec3(0, 1, 1));
    constexpr std::array<std::uint8_t, 4> kUp = {128, 218, 218, 255}; // +Y and +Z alike.
    const float right = shadeMapped(kUp, {1, 0, 0, 1}, fromTop)[0];
    const float mirrored = shadeMapped(kUp, {1, 0, 0, -1}, fromTop)[0];
    EXPECT_NEAR(right, radianceOf({.normal = fromTop, .toLight = fromTop}, Brdf::Gltf).x, 0.01);
    EXPECT_NEAR(mirrored, 0, 0.01);
}

} // namespace
} // namespace franken::test
