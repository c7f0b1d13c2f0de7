// SPDX-License-Identifier: MIT
#include "franken/generator/budget.h"

#include "franken/generator/choices.h"
#include "franken/generator/compose.h"
#include "franken/generator/effect.h"
#include "franken/generator/texture_role.h"
#include "without.h"

#include <algorithm>
#include <numeric>

namespace franken {
namespace {

constexpr std::array<std::string_view, kResourceCount> kResourceNames = {
    "attributes", "varyings", "vertex-uniforms", "fragment-uniforms", "samplers", "lights"};

// vc4, v3d: glGetIntegerv of Mesa 25.0.7; mali-400: src/gallium/drivers/lima/lima_screen.c
// of Mesa, which spills; software: the smaller of softpipe's and llvmpipe's in 22.3.6;
// es2-minimum: OpenGL ES 2.0.25, tables 6.19 and 6.20. vc4 does not spill: see lightsBeside().
constexpr Profile kProfiles[] = {
    {"vc4", "VideoCore IV, Pi 0 to 3 (Mesa 25.0.7)", {8, 8, 4088, 4095, 16, 4}},
    {"v3d", "VideoCore VI and VII, Pi 4 and 5 (Mesa 25.0.7)", {16, 16, 4096, 4095, 24, 8}},
    {"mali-400",
     "Mali-400 and Mali-450, lima (Mesa 25.0.7); fragments in 16 bits",
     {16, 12, 304, 2048, 16, 8}},
    {"es2-minimum", "the least that OpenGL ES 2.0 allows", {8, 8, 128, 16, 8, 8}},
    {"software", "softpipe and llvmpipe (Mesa 22.3.6)", {16, 32, 4096, 4096, 32, 8}},
};

// A variable in the grid of appendix A.7: so many of the four columns, on so many successive rows.
struct Footprint {
    int columns, rows;
};

Footprint blockOf(Type type, int count) {
    switch (type) {
    case Type::Mat4:
        return {4, 4 * count};
    case Type::Mat3:
        return {3, 3 * count};
    default:
        return {componentCount(type), count};
    }
}

class Grid {
public:
    explicit Grid(int height) : m_taken(static_cast<std::size_t>(height)) {}

    // Vectors lie in the first columns, from the top; pairs that find no row of their own lie in the last
    // two, from the bottom; single floats fill the column that has the least room for them.
    bool place(Footprint block) {
        if (block.columns == 1)
            return placeFloats(block);
        if (const int row = firstRow(block, 0); row >= 0)
            return take(block, row, 0);
        if (const int row = lastRow(block, 2); block.columns == 2 && row >= 0)
            return take(block, row, 2);
        return false;
    }

private:
    using Row = std::array<bool, 4>;

    int height() const { return static_cast<int>(m_taken.size()); }

    bool isFree(Footprint block, int row, int column) const {
        for (int y = row; y < row + block.rows; ++y)
            for (int x = column; x < column + block.columns; ++x)
                if (m_taken[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)])
                    return false;
        return true;
    }

    int firstRow(Footprint block, int column) const {
        for (int row = 0; row + block.rows <= height(); ++row)
            if (isFree(block, row, column))
                return row;
        return -1;
    }

    int lastRow(Footprint block, int column) const {
        int row = height() - block.rows;
        while (row >= 0 && !isFree(block, row, column))
            --row;
        return row;
    }

    bool placeFloats(Footprint block) {
        int best = -1;
        std::ptrdiff_t bestRoom = height() + 1;
        for (int column = 0; column < 4; ++column) {
            const auto room = std::count_if(m_taken.begin(), m_taken.end(), [column](const Row& row) {
                return !row[static_cast<std::size_t>(column)];
            });
            if (room < bestRoom && firstRow(block, column) >= 0) {
                best = column;
                bestRoom = room;
            }
        }
        return best >= 0 && take(block, firstRow(block, best), best);
    }

    bool take(Footprint block, int row, int column) {
        for (int y = row; y < row + block.rows; ++y)
            for (int x = column; x < column + block.columns; ++x)
                m_taken[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = true;
        return true;
    }

    std::vector<Row> m_taken;
};

int packedVectors(std::vector<Footprint> blocks) {
    std::stable_sort(blocks.begin(), blocks.end(), [](Footprint a, Footprint b) {
        return a.columns != b.columns ? a.columns > b.columns : a.rows > b.rows;
    });
    const int floats = std::accumulate(blocks.begin(), blocks.end(), 0, [](int sum, Footprint block) {
        return sum + block.columns * block.rows;
    });
    for (int height = (floats + 3) / 4;; ++height) {
        Grid grid(height);
        if (std::all_of(blocks.begin(), blocks.end(), [&](Footprint block) { return grid.place(block); }))
            return height;
    }
}

int uniformVectors(const Interface& interface, bool Uniform::*stage) {
    std::vector<Footprint> blocks;
    for (const Uniform& uniform : interface.uniforms)
        if (uniform.*stage)
            blocks.push_back(blockOf(uniform.type, uniform.count));
    return packedVectors(std::move(blocks));
}

int usedOf(const Interface& interface, Resource resource) {
    switch (resource) {
    case Resource::Attributes: {
        int vectors = 0;
        for (const Attribute& attribute : interface.attributes)
            vectors += blockOf(attribute.type, 1).rows;
        return vectors;
    }
    case Resource::Varyings: {
        std::vector<Footprint> blocks;
        for (const Varying& varying : interface.varyings)
            blocks.push_back(blockOf(varying.type, 1));
        return packedVectors(std::move(blocks));
    }
    case Resource::VertexUniforms:
        return uniformVectors(interface, &Uniform::vertex);
    case Resource::FragmentUniforms:
        return uniformVectors(interface, &Uniform::fragment);
    case Resource::Samplers:
        return static_cast<int>(interface.samplers.size());
    case Resource::Lights:
        return interface.lights;
    }
    return 0;
}

// The largest number of lights of a program: all suns and punctual lights.
constexpr int kMostLights = 2 * Permutation::kMaxLights;

// How many lights a compiler that cannot spill has registers for, beside what the program holds over all of
// them: texels, a lobe whose roughness is the pixel's, the vertex colour, and the cones' axes. Fitted to
// Mesa's compiler for vc4: of 386 programs with five to eight lights it gives up on 11, which all exceed this
// limit, as do 112 of the others; with up to four lights all have their registers (tests/qpu).
int lightsBeside(const Interface& interface) {
    const auto hasUniform = [&](std::string_view name) {
        return std::any_of(interface.uniforms.begin(), interface.uniforms.end(),
                           [name](const Uniform& uniform) { return uniform.name == name; });
    };
    const bool coloured = std::any_of(interface.varyings.begin(), interface.varyings.end(),
                                      [](const Varying& varying) { return varying.name == "vColor"; });
    constexpr int kRegisters = 35, kOfALight = 4, kOfALobe = 4, kOfAColour = 2, kOfCones = 2;
    const int held = static_cast<int>(interface.samplers.size()) +
                     (hasUniform("uMetallicRoughness") ? kOfALobe : 0) + (coloured ? kOfAColour : 0) +
                     (hasUniform("uPunctual0Axis") ? kOfCones : 0);
    return std::min((kRegisters - held) / kOfALight, kMostLights);
}

int limitOf(const Interface& interface, const Profile& profile, Resource resource) {
    const int limit = profile.limits[static_cast<std::size_t>(resource)];
    if (resource != Resource::Lights || limit >= kMostLights)
        return limit;
    return std::max(limit, lightsBeside(interface));
}

} // namespace

std::string_view toText(Resource resource) { return kResourceNames[static_cast<std::size_t>(resource)]; }

std::span<const Profile> profiles() { return kProfiles; }

Result<Profile> findProfile(std::string_view name) {
    std::string known;
    for (const Profile& profile : profiles()) {
        if (profile.name == name)
            return profile;
        known.append(known.empty() ? "" : ", ").append(profile.name);
    }
    return Error{"budget.unknown-profile", std::string(name), "there is no such profile",
                 "the profiles are " + known};
}

bool Budget::fits() const {
    return rolesBeyond.empty() &&
           std::none_of(uses.begin(), uses.end(), [](const Use& use) { return use.exceeded(); });
}

Budget budget(const Interface& interface, const Profile& profile) {
    Budget result{};
    for (std::size_t i = 0; i < kResourceCount; ++i) {
        const auto resource = static_cast<Resource>(i);
        result.uses[i] = {resource, usedOf(interface, resource), limitOf(interface, profile, resource)};
    }
    for (const Sampler& sampler : interface.samplers)
        if (sampler.unit >= result[Resource::Samplers].limit)
            result.rolesBeyond.push_back(findTextureRole(sampler.name)->name);
    return result;
}

std::vector<Feature> costlyFeatures(const Permutation& permutation, Resource resource,
                                    const SnippetSet& snippets) {
    const int used = usedOf(compose(permutation, snippets).interface, resource);
    std::vector<Feature> features;
    const auto tryLess = [&](std::string_view word, const Permutation& less) {
        const auto canonical = canonicalise(less);
        if (!canonical)
            return;
        if (const int left = usedOf(compose(canonical->permutation, snippets).interface, resource);
            left < used)
            features.push_back({std::string(word), left});
    };
    for (const Choice& choice : choices())
        if (const unsigned value = choice.get(permutation); value != 0 && choice.name != "program")
            tryLess(choice.options[value].word, without(permutation, choice));
    if (const Effect* const effect = snippets.effectOf(permutation.effect); effect != nullptr)
        tryLess(effect->name(), withoutEffect(permutation));
    std::stable_sort(features.begin(), features.end(),
                     [](const Feature& a, const Feature& b) { return a.used < b.used; });
    return features;
}

} // namespace franken
