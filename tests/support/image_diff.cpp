// SPDX-License-Identifier: MIT
#include "support/image_diff.h"

#include "franken/png.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace franken::test {
namespace {

std::size_t offsetOf(const Picture& image, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                static_cast<std::size_t>(x));
}

Picture amplified(const Picture& actual, const Picture& expected) {
    Picture diff = actual;
    for (std::size_t i = 0; i < diff.rgba.size(); ++i)
        diff.rgba[i] = static_cast<std::uint8_t>(
            std::clamp(128 + 16 * (int{actual.rgba[i]} - int{expected.rgba[i]}), 0, 255));
    return diff;
}

} // namespace

int Difference::max() const {
    for (int codes = 255; codes > 0; --codes)
        if (worst[static_cast<std::size_t>(codes)] > 0)
            return codes;
    return 0;
}

double Difference::shareAbove(int codes) const {
    std::size_t above = 0;
    for (std::size_t i = static_cast<std::size_t>(codes) + 1; i < worst.size(); ++i)
        above += worst[i];
    return pixels == 0 ? 0 : static_cast<double>(above) / static_cast<double>(pixels);
}

std::ostream& operator<<(std::ostream& out, const Difference& difference) {
    return out << "mean " << difference.mean << " (signed " << difference.bias << "), max "
               << difference.max() << ", off by more than 1: " << 100 * difference.shareAbove(1)
               << " %, than 6: " << 100 * difference.shareAbove(6) << " % of " << difference.pixels
               << " pixels";
}

Difference compare(const Picture& actual, const Picture& expected, const Mask& mask) {
    assert(actual.width == expected.width && actual.height == expected.height);
    Difference difference;
    double sum = 0, signedSum = 0;
    for (int y = 0; y < actual.height; ++y)
        for (int x = 0; x < actual.width; ++x) {
            if (!mask(x, y))
                continue;
            ++difference.pixels;
            int worst = 0;
            for (std::size_t i = offsetOf(actual, x, y); i < offsetOf(actual, x, y) + 3; ++i) {
                const int off = int{actual.rgba[i]} - int{expected.rgba[i]};
                signedSum += off;
                sum += std::abs(off);
                worst = std::max(worst, std::abs(off));
            }
            ++difference.worst[static_cast<std::size_t>(worst)];
        }
    const double channels = std::max<double>(1, 3 * static_cast<double>(difference.pixels));
    difference.mean = sum / channels;
    difference.bias = signedSum / channels;
    return difference;
}

Difference compareLit(const Picture& actual, const Picture& expected) {
    const auto lit = [](const Picture& image, std::size_t i) {
        return image.rgba[i] > 0 || image.rgba[i + 1] > 0 || image.rgba[i + 2] > 0;
    };
    return compare(actual, expected, [&](int x, int y) {
        const std::size_t i = offsetOf(actual, x, y);
        return lit(actual, i) || lit(expected, i);
    });
}

std::string writeDifference(const std::string& name, const Picture& actual, const Picture& expected) {
    const std::filesystem::path folder = std::filesystem::path(FRANKEN_BINARY_DIR) / "diffs";
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    std::string text = "see " + (folder / name).string() + ".{actual,expected,diff}.png";
    const Picture diff = amplified(actual, expected);
    for (const auto& [suffix, image] : {std::pair(".actual.png", &actual),
                                        std::pair(".expected.png", &expected), std::pair(".diff.png", &diff)})
        if (const Result<void> written = writePng(folder / (name + suffix), *image); !written)
            text = toString(written.error());
    return text;
}

} // namespace franken::test
