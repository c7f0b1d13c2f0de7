// SPDX-License-Identifier: MIT
// dump_program NAME < SCENES
//
// A program as JSON, a document a line: first its two texts, then its uniforms' values for each line of
// SCENES, which is 11 numbers: base colour, metalness, roughness, the camera's place, and the direction to
// the sun, of pi lux. Further suns are dark. Where the program has no sun, its first punctual light stands
// for it, 2 m from the origin, and further ones are dark. The object's matrices are the identity.
#include "franken/generator/compose.h"
#include "franken/generator/pack.h"

#include <nlohmann/json.hpp>

#include <array>
#include <iostream>
#include <numbers>

using namespace franken;

namespace {

struct Blocks {
    FrameBlock frame{};
    LightsBlock lights{};
    MaterialBlock material{};
    ObjectBlock object{};
};

using Scene = std::array<float, 11>;

void packLights(Blocks& blocks, const Permutation& permutation, const Float3& toLight) {
    constexpr float kPi = std::numbers::pi_v<float>, kDistance = 2;
    for (std::size_t i = 0; i < Permutation::kMaxLights; ++i) {
        Sun sun;
        sun.direction = {-toLight[0], -toLight[1], -toLight[2]};
        sun.illuminance = i == 0 ? kPi : 0;
        packSun(blocks.lights, i, sun, 1);
        PunctualLight light;
        light.position = {kDistance * toLight[0], kDistance * toLight[1], kDistance * toLight[2]};
        light.intensity = i == 0 && permutation.suns == 0 ? kPi * kDistance * kDistance : 0;
        const auto [x, y, z] = blocks.frame.cameraPosition;
        packPunctualLight(blocks.lights, i, light, {x, y, z}, 1);
    }
}

Blocks pack(const Permutation& permutation, const Scene& scene) {
    Blocks blocks;
    MaterialFactors factors;
    factors.baseColor = {scene[0], scene[1], scene[2], 1};
    factors.metallic = scene[3];
    factors.roughness = scene[4];
    blocks.material = packMaterial(factors, permutation.brdf, 1);
    blocks.frame.cameraPosition = {scene[5], scene[6], scene[7]};
    packLights(blocks, permutation, {scene[8], scene[9], scene[10]});
    blocks.object.modelViewProjection =
        blocks.object.model = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    blocks.object.normalMatrix = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    return blocks;
}

const void* addressOf(const Blocks& blocks, Block block) {
    switch (block) {
    case Block::Frame:
        return &blocks.frame;
    case Block::Lights:
        return &blocks.lights;
    case Block::Material:
        return &blocks.material;
    case Block::Object:
        return &blocks.object;
    case Block::Skin:
    case Block::User:
        break;
    }
    return nullptr;
}

nlohmann::json valuesOf(const Blocks& blocks, const Uniform& uniform) {
    const int offset = fieldOffset(uniform);
    const auto* floats = static_cast<const float*>(addressOf(blocks, uniform.block)) + offset;
    const auto count = static_cast<std::size_t>(componentCount(uniform.type) * uniform.count);
    return std::vector<float>(floats, floats + count);
}

bool readScene(std::istream& in, Scene& scene) {
    for (float& number : scene)
        if (!(in >> number))
            return false;
    return true;
}

void dump(const Permutation& permutation) {
    const Composed program = compose(permutation);
    std::cout << nlohmann::json{{"vertex", program.vertex.text}, {"fragment", program.fragment.text}}.dump()
              << '\n';
    for (Scene scene{}; readScene(std::cin, scene);) {
        const Blocks blocks = pack(permutation, scene);
        nlohmann::json uniforms;
        for (const Uniform& uniform : program.interface.uniforms)
            uniforms[uniform.name] = valuesOf(blocks, uniform);
        std::cout << uniforms.dump() << '\n';
    }
}

} // namespace

int main(int argc, char** argv) {
    const auto parsed = parseName(argc == 2 ? argv[1] : "");
    const auto canonical = parsed ? canonicalise(*parsed) : Result<Canonical>(parsed.error());
    if (!canonical) {
        std::cerr << toString(canonical.error()) << '\n';
        return 1;
    }
    dump(canonical->permutation);
    return 0;
}
