// SPDX-License-Identifier: MIT
#include "franken/generator/interface.h"

#include "franken/generator/texture_role.h"

#include <array>
#include <utility>

namespace franken {
namespace {

struct TypeRow {
    std::string_view glsl;
    int components;
};
constexpr std::array<TypeRow, 8> kTypes = {{{"float", 1},
                                            {"vec2", 2},
                                            {"vec3", 3},
                                            {"vec4", 4},
                                            {"mat3", 9},
                                            {"mat4", 16},
                                            {"sampler2D", 0},
                                            {"samplerCube", 0}}};
constexpr std::array<std::string_view, kBlocks> kBlockNames = {"frame",  "lights", "material",
                                                               "object", "skin",   "user"};

using Slot = std::pair<std::string_view, int>;
constexpr std::array<Slot, 8> kAttributes = {{{"aPosition", 0},
                                              {"aNormal", 1},
                                              {"aTangent", 2},
                                              {"aUv0", 3},
                                              {"aUv1", 4},
                                              {"aColor", 5},
                                              {"aJoints", 6},
                                              {"aWeights", 7}}};
} // namespace

std::string_view toGlsl(Type type) { return kTypes[static_cast<std::size_t>(type)].glsl; }
int componentCount(Type type) { return kTypes[static_cast<std::size_t>(type)].components; }
std::string_view toText(Block block) { return kBlockNames[static_cast<std::size_t>(block)]; }

int attributeLocation(std::string_view name) {
    for (const auto& [attribute, location] : kAttributes)
        if (attribute == name)
            return location;
    return -1;
}

int samplerUnit(std::string_view name) {
    const TextureRoleRow* row = findTextureRole(name);
    return row != nullptr ? static_cast<int>(row->unit) : -1;
}

} // namespace franken
