// SPDX-License-Identifier: MIT
#include "blocks.h"

#include "subject.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace franken::gallery {
namespace {

constexpr glm::vec3 kEye = {0, 1.5f, 3.4f};
constexpr float kFarthest = 5; // Of what is lit, from the eye, m.
constexpr float kExposure = 1;

template<typename Values, typename Matrix>
void copy(Values& values, const Matrix& matrix) {
    std::copy_n(glm::value_ptr(matrix), values.size(), values.begin());
}

MaterialFactors factorsFor(const Permutation& permutation) {
    MaterialFactors factors;
    if (!permutation.baseColorTexture && !permutation.vertexColor)
        factors.baseColor = {0.55f, 0.12f, 0.05f, 0.5f};
    if (permutation.metallicRoughness == MetallicRoughness::Factors) {
        factors.metallic = 0;
        factors.roughness = 0.35f;
    }
    factors.emissive = permutation.emissive == Emissive::Texture ? Float3{1, 1, 1} : Float3{0.25f, 0.1f, 0};
    return factors;
}

/// Turns the coordinates, and makes the tiles larger.
Float9 uvTransform() {
    glm::mat3 transform(1.0f);
    transform[0] = {0.42f, 0.42f, 0};
    transform[1] = {-0.42f, 0.42f, 0};
    Float9 values;
    copy(values, transform);
    return values;
}

LightsBlock lightsFor(const BakedSky& sky, const Permutation& permutation) {
    LightsBlock block{};
    block.ambient = packAmbient(
        {.kind = permutation.ambient, .color = {0.12f, 0.14f, 0.18f}, .sky = sky.coefficients}, kExposure);
    const Sun suns[] = {{.direction = {0.7f, -0.8f, -0.9f}, .color = {1, 0.95f, 0.85f}, .illuminance = 3.2f},
                        {.direction = {-1, -0.3f, -0.4f}, .color = {0.3f, 0.5f, 1}, .illuminance = 2.5f},
                        {.direction = {0.1f, 1, -0.4f}, .color = {1, 0.35f, 0.2f}, .illuminance = 2.0f},
                        {.direction = {1, 0.2f, 0.1f}, .color = {0.3f, 1, 0.5f}, .illuminance = 2.0f}};
    const PunctualLight lamps[] = {{.position = {1.3, 0.9, 1.0},
                                    .direction = {-1.0f, -0.8f, -0.7f},
                                    .color = {1, 0.6f, 0.2f},
                                    .intensity = 3},
                                   {.position = {-1.3, -0.7, 1.0},
                                    .direction = {1.0f, 0.6f, -0.7f},
                                    .color = {0.6f, 0.3f, 1},
                                    .intensity = 3},
                                   {.position = {1.2, -1.0, 0.9},
                                    .direction = {-1.0f, 0.9f, -0.7f},
                                    .color = {0.2f, 1, 0.8f},
                                    .intensity = 3},
                                   {.position = {-0.4, 1.7, 0.9},
                                    .direction = {0.3f, -1.5f, -0.7f},
                                    .color = {1, 0.3f, 0.5f},
                                    .intensity = 3}};
    for (std::size_t i = 0; i < Permutation::kMaxLights; ++i) {
        packSun(block, i, suns[i], kExposure);
        PunctualLight lamp = lamps[i];
        lamp.spot = permutation.spots;
        lamp.innerCone = 0.22f;
        lamp.outerCone = 0.42f;
        packPunctualLight(block, i, lamp, {kEye.x, kEye.y, kEye.z}, kExposure);
    }
    return block;
}

FrameBlock frameFor(const BakedSky& sky) {
    FrameBlock block{};
    block.cameraPosition = {kEye.x, kEye.y, kEye.z};
    // A sky alone is seen from elsewhere: level, towards its sun.
    const glm::mat3 toSky =
        glm::transpose(glm::mat3(glm::lookAt({}, glm::vec3(-0.6f, 0.25f, 0.7f), {0, 1, 0})));
    copy(block.clipToSky,
         toSky * glm::mat3(glm::vec3(0.7f, 0, 0), glm::vec3(0, 0.7f, 0), glm::vec3(0, 0, -1)));
    block.skyRange = sky.skybox.range * kExposure;
    block.reflectionScale = std::sqrt(sky.reflection.atlas.range * kExposure);
    block.dither = packDither({3, 3, 3});
    return block;
}

/// The skeleton bends to the right, the more the higher a joint is; the middle one stays.
SkinBlock bentSkin() {
    SkinBlock block{};
    for (int joint = 0; joint < kJoints; ++joint) {
        const float height = heightOf(joint);
        const glm::mat4 bent = glm::rotate(glm::translate(glm::mat4(1), {0.35f * height * height, 0, 0}),
                                           -0.35f * height, {0, 0, 1});
        for (int row = 0; row < 3; ++row)
            block.joints[static_cast<std::size_t>(3 * joint + row)] = {bent[0][row], bent[1][row],
                                                                       bent[2][row], bent[3][row]};
    }
    return block;
}

} // namespace

Blocks blocksFor(const Permutation& permutation, const BakedSky& sky) {
    const glm::mat4 projection = glm::perspective(0.63f, 1.0f, 0.5f, 20.0f);
    const glm::mat4 view = glm::lookAt(kEye, glm::vec3(0), glm::vec3(0, 1, 0));
    const glm::mat4 model = glm::rotate(glm::mat4(1), 0.2f, {0, 1, 0});
    Blocks blocks;
    blocks.frame = frameFor(sky);
    blocks.lights = lightsFor(sky, permutation);
    if (permutation.precision == Precision::Fp16) {
        blocks.frame.lengthScale = lengthScaleFp16(kFarthest);
        blocks.frame.lengthUnit = 1 / blocks.frame.lengthScale;
        blocks.frame.skyRange = std::min(blocks.frame.skyRange, kMostFp16);
        fitToFp16(blocks.lights, kFarthest);
    }
    blocks.material =
        packMaterial(factorsFor(permutation), permutation.brdf, kExposure, permutation.precision);
    blocks.material.uv = {uvTransform(), uvTransform()};
    copy(blocks.object.modelViewProjection, projection * view * model);
    copy(blocks.object.model, model);
    copy(blocks.object.normalMatrix, glm::inverseTranspose(glm::mat3(model)));
    copy(blocks.object.overlay, glm::mat3(1));
    blocks.skin = bentSkin();
    return blocks;
}

} // namespace franken::gallery
