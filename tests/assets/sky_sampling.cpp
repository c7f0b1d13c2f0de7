// SPDX-License-Identifier: MIT
#include "sky_sampling.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>

#include <glm/geometric.hpp>

namespace franken::test {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Smith's masking of one direction for GGX.
float lambda(float cosine, float alpha) {
    return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
}

/// Calls visit(direction towards the light, weight, Schlick's (1 - V.H)^5) for samples of the microfacets
/// that the eye sees (Heitz, "Sampling the GGX Distribution of Visible Normals", 2018). The weights' mean is
/// the integral of the BRDF without Fresnel.
void sampleLobe(float nDotV, float roughness, int samples,
                const std::function<void(const glm::vec3&, float, float)>& visit) {
    const float alpha = roughness * roughness;
    const glm::vec3 v(std::sqrt(1 - nDotV * nDotV), 0, nDotV);
    const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * v.x, 0, v.z));
    const glm::vec3 side(0, 1, 0), up = glm::cross(stretched, side);
    for (int i = 0; i < samples; ++i) {
        const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(samples));
        const float angle = 2.3999632f * static_cast<float>(i);
        const float a = radius * std::cos(angle), share = 0.5f * (1 + stretched.z);
        const float b = (1 - share) * std::sqrt(1 - a * a) + share * radius * std::sin(angle);
        const glm::vec3 n = side * a + up * b + stretched * std::sqrt(std::max(1 - a * a - b * b, 0.0f));
        const glm::vec3 h = glm::normalize(glm::vec3(alpha * n.x, alpha * n.y, std::max(n.z, 0.0f)));
        const float vDotH = glm::dot(v, h);
        const glm::vec3 l = 2 * vDotH * h - v;
        if (l.z > 0)
            visit(l, (1 + lambda(nDotV, alpha)) / (1 + lambda(nDotV, alpha) + lambda(l.z, alpha)),
                  std::pow(std::max(1 - vDotH, 0.0f), 5.0f));
    }
}

} // namespace

std::vector<glm::vec3> directions(int count) {
    std::vector<glm::vec3> all;
    for (int i = 0; i < count; ++i) {
        const float y = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count);
        const float ring = std::sqrt(1 - y * y), angle = 2.3999632f * static_cast<float>(i);
        all.emplace_back(ring * std::cos(angle), y, ring * std::sin(angle));
    }
    return all;
}

glm::vec3 equirectDirection(int width, int x, int y) {
    const float azimuth = ((static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 0.5f) * 2 * kPi;
    const float polar = (static_cast<float>(y) + 0.5f) / static_cast<float>(width) * 2 * kPi;
    const float ring = std::sin(polar);
    return {ring * std::sin(azimuth), std::cos(polar), -ring * std::cos(azimuth)};
}

glm::vec3 faceTexelDirection(int size, int face, int x, int y) {
    const float s = (2 * static_cast<float>(x) + 1) / static_cast<float>(size) - 1;
    const float t = (2 * static_cast<float>(y) + 1) / static_cast<float>(size) - 1;
    const glm::vec3 faces[] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return glm::normalize(faces[face]);
}

void expose(Environment& sky, float mean) {
    double light = 0, area = 0;
    for (int y = 0; y < sky.height; ++y)
        for (int x = 0; x < sky.width; ++x) {
            const double weight = std::sin((y + 0.5) * std::numbers::pi / sky.height);
            light += weight * glm::dot(sky.texels[static_cast<std::size_t>(y * sky.width + x)],
                                       glm::vec3(0.2126f, 0.7152f, 0.0722f));
            area += weight;
        }
    for (glm::vec3& texel : sky.texels)
        texel *= mean * static_cast<float>(area / light);
}

Result<Environment> loadExposed(const std::filesystem::path& file) {
    auto sky = loadEnvironment(file);
    if (sky) {
        takeSun(*sky);
        expose(*sky, 0.5f);
    }
    return sky;
}

Frame::Frame(const glm::vec3& normal, float angle) : z(normal) {
    const glm::vec3 other = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(other, normal));
    x = right * std::cos(angle) + glm::cross(normal, right) * std::sin(angle);
    y = glm::cross(z, x);
}

glm::vec2 whiteSky(float nDotV, float roughness, int samples) {
    glm::vec2 sum(0);
    sampleLobe(nDotV, roughness, samples, [&](const glm::vec3&, float weight, float fresnel) {
        sum += weight * glm::vec2(1 - fresnel, fresnel);
    });
    return sum / static_cast<float>(samples);
}

Reflected reflected(const Environment& sky, const Frame& frame, float nDotV, float roughness) {
    // Enough for 0.2 codes of noise in the mean: the widest lobes need most.
    const int samples = 3000;
    Reflected sum;
    sampleLobe(nDotV, roughness, samples, [&](const glm::vec3& l, float weight, float fresnel) {
        const glm::vec3 light = weight / static_cast<float>(samples) * radianceFrom(sky, frame.toWorld(l));
        sum.byF0 += (1 - fresnel) * light;
        sum.besides += fresnel * light;
    });
    return sum;
}

std::optional<Hit> hitSphere(int x, int y, int size) {
    const float scale = std::tan(20 * kPi / 180);
    const glm::vec2 point((2 * static_cast<float>(x) + 1) / static_cast<float>(size) - 1,
                          1 - (2 * static_cast<float>(y) + 1) / static_cast<float>(size));
    const glm::vec3 ray = glm::normalize(glm::vec3(point.x * scale, point.y * scale, -1)), eye(0, 0, 4);
    const float along = -glm::dot(ray, eye), inside = along * along - 15;
    if (inside <= 0)
        return std::nullopt;
    return Hit{eye + ray * (along - std::sqrt(inside)), -ray};
}

Image readImage(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
    auto image = decodeImage(bytes);
    return image ? *image : Image{};
}

} // namespace franken::test
