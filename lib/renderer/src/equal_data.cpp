// SPDX-License-Identifier: MIT
#include "equal_data.h"

#include <cstring>
#include <string_view>

namespace franken {
namespace {

template<typename Value>
std::string_view bytesOf(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

/// Calls the function with the bytes of each array of both.
template<typename Function>
bool allOf(const Primitive& a, const Primitive& b, Function equal) {
    return equal(bytesOf(a.positions), bytesOf(b.positions)) &&
           equal(bytesOf(a.normals), bytesOf(b.normals)) && equal(bytesOf(a.tangents), bytesOf(b.tangents)) &&
           equal(bytesOf(a.uv[0]), bytesOf(b.uv[0])) && equal(bytesOf(a.uv[1]), bytesOf(b.uv[1])) &&
           equal(bytesOf(a.colors), bytesOf(b.colors)) && equal(bytesOf(a.indices), bytesOf(b.indices));
}

std::size_t combined(std::size_t hash, std::size_t next) {
    constexpr std::size_t kGolden = 0x9E3779B9; // Boost's hash_combine().
    return hash ^ (next + kGolden + (hash << 6) + (hash >> 2));
}

} // namespace

std::size_t GeometryHash::operator()(const Primitive* primitive) const {
    std::size_t hash = 0;
    allOf(*primitive, *primitive, [&](std::string_view bytes, std::string_view) {
        hash = combined(hash, std::hash<std::string_view>()(bytes));
        return true;
    });
    return hash;
}

bool GeometryEqual::operator()(const Primitive* a, const Primitive* b) const {
    return a == b ||
           (a->deformation == b->deformation &&
            allOf(*a, *b, [](std::string_view left, std::string_view right) { return left == right; }));
}

std::size_t SampledImageHash::operator()(const SampledImage& texture) const {
    const Image& image = *texture.image;
    return combined(std::hash<std::string_view>()(bytesOf(image.rgba.empty() ? image.encoded : image.rgba)),
                    static_cast<std::size_t>(texture.image->width));
}

bool SampledImageEqual::operator()(const SampledImage& a, const SampledImage& b) const {
    return a.contents == b.contents && a.widening == b.widening && a.sampling.wrapS == b.sampling.wrapS &&
           a.sampling.wrapT == b.sampling.wrapT && a.sampling.magFilter == b.sampling.magFilter &&
           a.sampling.minFilter == b.sampling.minFilter && a.image->width == b.image->width &&
           (a.image == b.image || (a.image->rgba == b.image->rgba && a.image->encoded == b.image->encoded));
}

} // namespace franken
