// SPDX-License-Identifier: MIT
// Folds what the page's controls say into blocks of uniforms, by the functions that the renderer calls. Every
// call reads doubles from the input, in the order of its comment, and returns where its block is.
#include "exchange.h"
#include "franken/generator/pack.h"
#include "franken/light.h"
#include "franken/viewpoint.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace franken::web {
namespace {

MaterialBlock g_material;
LightsBlock g_lights;
FrameBlock g_frame;
ObjectBlock g_object;
SkinBlock g_skin;
Viewpoint g_view;

/// Takes numbers from the input, one after the other.
class Reader {
public:
    explicit Reader(std::size_t most) : m_rest(inputNumbers(most)) {}

    double real() {
        const double value = m_rest.front();
        m_rest = m_rest.subspan(1);
        return value;
    }
    float number() { return static_cast<float>(real()); }
    bool flag() { return real() != 0; }
    glm::dvec3 point() {
        const double x = real(), y = real();
        return {x, y, real()};
    }
    template<typename Floats>
    void fill(Floats&& floats) {
        for (float& each : floats)
            each = number();
    }

private:
    std::span<const double> m_rest;
};

Sun readSun(Reader& in) {
    Sun sun;
    in.fill(sun.direction);
    in.fill(sun.color);
    sun.illuminance = in.number();
    return sun;
}

PunctualLight readPunctualLight(Reader& in) {
    PunctualLight light;
    for (double& each : light.position)
        each = in.real();
    in.fill(light.direction);
    in.fill(light.color);
    light.intensity = in.number();
    light.range = in.number();
    light.spot = in.flag();
    light.innerCone = in.number();
    light.outerCone = in.number();
    return light;
}

// glm::lookAt, the other way round: from the camera to the world. Straight up and down there is no right
// side.
glm::dmat4 cameraAt(const glm::dvec3& eye, const glm::dvec3& target) {
    return glm::inverse(glm::lookAt(eye, target, glm::dvec3(0, 1, 0)));
}

template<typename Values, typename Matrix>
void roundTo(Values& values, const Matrix& matrix) {
    std::transform(glm::value_ptr(matrix), glm::value_ptr(matrix) + values.size(), values.begin(),
                   [](double value) { return static_cast<float>(value); });
}

constexpr std::size_t kMostNumbers = 256; ///< Of any block here.

} // namespace
} // namespace franken::web

using namespace franken;
using namespace franken::web;

/// BRDF, precision (the values of their choices), exposure; the factors of kMaterialFactors; two matrices of
/// texture coordinates, column by column.
FRANKEN_EXPORT(packMaterial) float* packMaterialBlock() {
    Reader in(kMostNumbers);
    const auto brdf = static_cast<Brdf>(in.real());
    const auto precision = static_cast<Precision>(in.real());
    const float exposure = in.number();
    MaterialFactors factors;
    for (const FactorRow& row : kMaterialFactors)
        in.fill(row.of(factors));
    g_material = packMaterial(factors, brdf, exposure, precision);
    in.fill(g_material.uv.uv0);
    in.fill(g_material.uv.uv1);
    return reinterpret_cast<float*>(&g_material);
}

/// Exposure; the eye; precision, and the farthest surface from the eye; kind of ambient light, its colour, 27
/// coefficients; how many suns, each: direction, colour, lux; how many punctual lights, each: position,
/// direction, colour, candela, range, whether it is a spot, inner and outer angle.
FRANKEN_EXPORT(packLights) float* packLightsBlock() {
    Reader in(kMostNumbers);
    Lighting lighting;
    lighting.exposure = in.number();
    const glm::dvec3 eye = in.point();
    const auto precision = static_cast<Precision>(in.real());
    const float farthest = in.number();
    lighting.ambient.kind = static_cast<Ambient>(in.real());
    in.fill(lighting.ambient.color);
    for (Float3& each : lighting.ambient.sky)
        in.fill(each);
    const auto suns = std::min<double>(in.real(), Permutation::kMaxLights);
    for (int i = 0; i < suns; ++i)
        lighting.suns.push_back(readSun(in));
    const auto punctual = std::min<double>(in.real(), Permutation::kMaxLights);
    for (int i = 0; i < punctual; ++i)
        lighting.punctualLights.push_back(readPunctualLight(in));
    g_lights = packLighting(lighting, eye);
    if (precision == Precision::Fp16)
        fitToFp16(g_lights, farthest);
    return reinterpret_cast<float*>(&g_lights);
}

/// Eye, target; vertical angle (radians), aspect, near and far plane; ranges of skybox and reflection;
/// exposure; bits of each channel; precision, and the farthest surface from the eye.
FRANKEN_EXPORT(packFrame) float* packFrameBlock() {
    Reader in(kMostNumbers);
    Camera camera;
    const glm::dvec3 eye = in.point();
    camera.world = cameraAt(eye, in.point());
    camera.yfov = in.number();
    const double aspect = in.real();
    camera.znear = in.number();
    camera.zfar = in.number();
    g_view = viewpointOf(camera, aspect);
    const float skyRange = in.number(), reflectionRange = in.number(), exposure = in.number();
    const int bits = static_cast<int>(in.real());
    const bool isFp16 = static_cast<Precision>(in.real()) == Precision::Fp16;
    const float farthest = in.number();
    g_frame = {};
    roundTo(g_frame.clipToSky, g_view.clipToSky);
    g_frame.skyRange = isFp16 ? std::min(skyRange * exposure, kMostFp16) : skyRange * exposure;
    g_frame.reflectionScale = std::sqrt(reflectionRange * exposure);
    g_frame.dither = packDither({bits, bits, bits});
    g_frame.lengthScale = isFp16 ? lengthScaleFp16(farthest) : 1;
    g_frame.lengthUnit = 1 / g_frame.lengthScale;
    return reinterpret_cast<float*>(&g_frame);
}

/// Object to world, column by column; whether front faces wind clockwise. After packFrame(): the model matrix
/// leads to the world as seen from its eye.
FRANKEN_EXPORT(packObject) float* packObjectBlock() {
    Reader in(kMostNumbers);
    glm::dmat4 world;
    for (int i = 0; i < 16; ++i)
        world[i / 4][i % 4] = in.real();
    const double side = in.flag() ? -1 : 1;
    roundTo(g_object.modelViewProjection, g_view.viewProjection * world);
    const glm::dmat3 m(world);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    roundTo(g_object.normalMatrix, side * cofactors);
    world[3] -= glm::dvec4(g_view.eye, 0);
    roundTo(g_object.model, world);
    g_object.overlay = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    return reinterpret_cast<float*>(&g_object);
}

/// Joints at rest: rows of the identity, for all of them.
FRANKEN_EXPORT(packSkin) float* packSkinBlock() {
    for (std::size_t i = 0; i < g_skin.joints.size(); ++i) {
        g_skin.joints[i] = {};
        g_skin.joints[i][i % 3] = 1;
    }
    return reinterpret_cast<float*>(&g_skin);
}
