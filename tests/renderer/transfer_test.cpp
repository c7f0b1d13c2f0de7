// SPDX-License-Identifier: MIT
// The transfer curves for all 256 codes, in floats, against the exact ones. Errors are in codes of 0-255.
#include "franken/gl_object.h"
#include "support/draw_scene.h"
#include "support/point_shader.h"

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

// IEC 61966-2-1; code and light 0 to 1.
double toLight(double code) { return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4); }
double toCode(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}
double toPow22(double light) { return std::pow(light, 1 / 2.2); }

class TransferTest : public OffscreenTest {
protected:
    /// What an unlit surface becomes whose factor is the light of each code.
    std::vector<double> encoded(Output output) {
        Permutation permutation;
        permutation.shading = Shading::Unlit;
        permutation.output = output;
        std::vector<ShadedPoint> points(256);
        for (std::size_t code = 0; code < points.size(); ++code) {
            const auto light = static_cast<float>(toLight(static_cast<double>(code) / 255));
            points[code].material = packMaterial({.baseColor = {light, light, light, 1}}, Brdf::Gltf, 1);
        }
        return red(permutation, points);
    }

    /// What an unlit surface becomes whose texture is each code, times a factor of linear light.
    std::vector<double> decoded(Decode decode, Output output, float factor = 1) {
        GlTexture codes(gl(), generate(gl().GenTextures));
        gl().ActiveTexture(GL_TEXTURE0);
        gl().BindTexture(GL_TEXTURE_2D, codes.name());
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        std::vector<std::uint8_t> texels;
        for (int code = 0; code < 256; ++code)
            for (const int channel : {code, code, code, 255})
                texels.push_back(static_cast<std::uint8_t>(channel));
        gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());

        Permutation permutation;
        permutation.shading = Shading::Unlit;
        permutation.baseColorTexture = true;
        permutation.decode = decode;
        permutation.output = output;
        std::vector<ShadedPoint> points(256);
        for (std::size_t code = 0; code < points.size(); ++code) {
            points[code].material = packMaterial({.baseColor = {factor, factor, factor, 1}}, Brdf::Gltf, 1);
            points[code].uv = {(static_cast<float>(code) + 0.5f) / 256, 0.5f};
        }
        return red(permutation, points);
    }

private:
    std::vector<double> red(const Permutation& permutation, const std::vector<ShadedPoint>& points) {
        std::vector<double> values;
        for (const auto& color : shade(gl(), canonicalise(permutation)->permutation, points))
            values.push_back(color[0]);
        return values;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, TransferTest, allBackends(), backendName);

/// The largest, in codes; `expected` is of the code, 0 to 1.
template<typename Expected>
double largestError(const std::vector<double>& values, Expected expected, std::size_t firstCode = 0) {
    EXPECT_EQ(values.size(), 256u);
    double largest = 0;
    for (std::size_t code = firstCode; code < values.size(); ++code)
        largest = std::max(largest, 255 * std::abs(values[code] - expected(static_cast<double>(code) / 255)));
    std::cout << "largest error: " << largest << " codes\n";
    return largest;
}

double sameCode(double code) { return code; }

TEST_P(TransferTest, EncodesExactly) { EXPECT_LE(largestError(encoded(Output::Srgb), sameCode), 0.01); }

TEST_P(TransferTest, EncodesFastWithinACodeFromCode10Up) {
    EXPECT_LE(largestError(encoded(Output::SrgbFast), sameCode, 10), 1);
}

TEST_P(TransferTest, EncodesByAPower) {
    const auto expected = [](double code) { return toPow22(toLight(code)); };
    EXPECT_LE(largestError(encoded(Output::Pow22), expected), 0.01);
}

TEST_P(TransferTest, DoesNotEncodeForALinearTarget) {
    EXPECT_LE(largestError(encoded(Output::Linear), toLight), 0.001);
}

TEST_P(TransferTest, DecodesExactly) {
    EXPECT_LE(largestError(decoded(Decode::Exact, Output::Linear), toLight), 0.01);
}

TEST_P(TransferTest, DecodesFast) {
    const std::vector<double> values = decoded(Decode::Fast, Output::Linear);
    EXPECT_LE(largestError(values, toLight), 0.5);
    // As the eye has it: encoded again, exactly.
    std::vector<double> codes;
    for (const double value : values)
        codes.push_back(toCode(std::max(value, 0.0)));
    EXPECT_LE(largestError(codes, sameCode), 5);
    EXPECT_LE(largestError(codes, sameCode, 40), 2);
}

TEST_P(TransferTest, DoesNotDecodeWhatIsLinear) {
    EXPECT_LE(largestError(decoded(Decode::None, Output::Linear), sameCode), 0.001);
}

/// Decode and encode cancel: what is left of the error is the straight part of the sRGB curve.
TEST_P(TransferTest, AnUnlitTexelStaysEncoded) {
    EXPECT_LE(largestError(decoded(Decode::Fast, Output::SrgbFast), sameCode), 0.01);
    for (const float factor : {0.8f, 0.3f, 0.05f, 0.0f}) {
        const auto exact = [&](double code) { return toCode(factor * toLight(code)); };
        std::vector<double> shown;
        for (const double value : decoded(Decode::Exact, Output::SrgbFast, factor))
            shown.push_back(std::max(value, 0.0)); // As the framebuffer clips it.
        EXPECT_LE(largestError(shown, exact), 2.8) << factor;
    }
}

TEST_P(TransferTest, ComesBackToTheSameCode) {
    EXPECT_LE(largestError(decoded(Decode::Exact, Output::Srgb), sameCode), 0.1);
}

} // namespace
} // namespace franken::test
