// SPDX-License-Identifier: MIT
// Models and skies for the page, through the library's own gate: what it refuses, it refuses here in its
// words.
#include "exchange.h"
#include "franken/baked_sky.h"
#include "franken/file.h"
#include "franken/gltf.h"
#include "franken/material.h"
#include "write_primitive.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace franken {

// The page has one file: what was dropped.
Result<std::vector<std::uint8_t>> readFile(const std::filesystem::path&, std::size_t maxBytes) {
    const std::span<const std::uint8_t> bytes = web::input();
    if (bytes.size() > maxBytes)
        return Error{"file.size", "",
                     "the file has " + std::to_string(bytes.size()) + " bytes, over the limit of " +
                         std::to_string(maxBytes),
                     "make it smaller"};
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}

Result<std::filesystem::path> findBelow(const std::filesystem::path&, const std::filesystem::path& name) {
    return Error{"file.open", name.string(), "a page reads no files beside the one that it is given",
                 "pack the model as .glb"};
}

namespace web {
namespace {

Scene g_scene;
BakedSky g_sky;

template<typename Matrix>
void writeMatrix(Json& json, std::string_view name, const Matrix& matrix, int count) {
    json.key(name).numbers(std::span(glm::value_ptr(matrix), static_cast<std::size_t>(count)));
}

void writeFactors(Json& json, const MaterialFactors& factors) {
    json.key("factors").begin('{');
    for (const FactorRow& row : kMaterialFactors)
        json.key(row.name).numbers(row.of(factors));
    json.end('}');
}

/// One for each pair of a mesh's primitive and its material, since the plan depends on both.
void writeMaterial(Json& json, const Primitive& primitive, const Log& log) {
    VertexContents contents = contentsOf(primitive);
    contents.influences = 0; // The arrays are at rest already.
    const MaterialPlan plan = planMaterial(g_scene, primitive.material, contents, log);
    const Material& material = g_scene.materials[static_cast<std::size_t>(primitive.material)];
    json.begin('{').member("name", material.name).member("doubleSided", material.doubleSided);
    json.member("permutation", toName(plan.permutation)).key("textures").numbers(plan.textures);
    json.key("uvSets").numbers(plan.uvSets);
    json.key("uv0").numbers(plan.uvTransforms.uv0).key("uv1").numbers(plan.uvTransforms.uv1);
    writeFactors(json, plan.factors);
    json.end('}');
}

void writeMeshes(Json& json, const Log& log) {
    json.key("meshes").begin('[');
    for (const Mesh& mesh : g_scene.meshes) {
        json.begin('[');
        for (const Primitive& primitive : mesh.primitives) {
            json.begin('{').key("arrays");
            writePrimitive(json, primitive);
            json.key("plan");
            writeMaterial(json, primitive, log);
            json.end('}');
        }
        json.end(']');
    }
    json.end(']');
}

void writeInstances(Json& json) {
    json.key("instances").begin('[');
    for (const Instance& instance : g_scene.instances)
        if (instance.visible) {
            json.begin('{').member("mesh", instance.mesh).member("mirrored", instance.mirrored);
            writeMatrix(json, "world", instance.world, 16);
            json.end('}');
        }
    json.end(']');
}

void writeTextures(Json& json) {
    json.key("images").begin('[');
    for (const Image& image : g_scene.images) {
        json.begin('{').member("width", image.width).member("height", image.height);
        writeArray(json, "encoded", image.encoded, 1);
        writeArray(json, "rgba", image.rgba, 1);
        json.end('}');
    }
    json.end(']').key("textures").begin('[');
    for (const Texture& texture : g_scene.textures) {
        json.begin('{').member("image", texture.image).member("wrapS", static_cast<int>(texture.wrapS));
        json.member("wrapT", static_cast<int>(texture.wrapT))
            .member("mag", static_cast<int>(texture.magFilter));
        json.member("min", static_cast<int>(texture.minFilter)).end('}');
    }
    json.end(']');
}

void writeBounds(Json& json) {
    const Box box = g_scene.bounds();
    json.key("least").numbers(std::span(glm::value_ptr(box.min), 3));
    json.key("most").numbers(std::span(glm::value_ptr(box.max), 3));
}

void writeImage(Json& json, std::string_view name, const Image& image) {
    json.key(name).begin('{').member("width", image.width).member("height", image.height);
    writeArray(json, "rgba", image.rgba, 1);
    json.end('}');
}

void writeSky(Json& json) {
    json.begin('{').key("coefficients").begin('[');
    for (const Float3& coefficient : g_sky.coefficients)
        for (const float value : coefficient)
            json.value(static_cast<double>(value));
    json.end(']');
    if (g_sky.sun) {
        json.key("sun")
            .begin('{')
            .key("direction")
            .numbers(g_sky.sun->direction)
            .key("color")
            .numbers(g_sky.sun->color);
        json.member("illuminance", static_cast<double>(g_sky.sun->illuminance)).end('}');
    }
    json.member("skyRange", static_cast<double>(g_sky.skybox.range));
    json.member("reflectionRange", static_cast<double>(g_sky.reflection.atlas.range)).key("faces").begin('[');
    for (const Image& face : g_sky.skybox.images) {
        json.begin('{').member("width", face.width).member("height", face.height);
        writeArray(json, "rgba", face.rgba, 1);
        json.end('}');
    }
    json.end(']');
    writeImage(json, "atlas", g_sky.reflection.atlas.image);
    writeImage(json, "lookup", g_sky.reflection.lookup);
    json.end('}');
}

} // namespace
} // namespace web
} // namespace franken

using namespace franken;
using namespace franken::web;

/// The scene of a .glb, of which the input is the name and then the bytes: arrays, materials, images, places;
/// or
/// {"error"}. Images stay encoded: the page decodes PNG and JPEG.
FRANKEN_EXPORT(loadModel) void loadModel(std::size_t nameSize) {
    Json warnings;
    warnings.begin('[');
    const Log log = [&warnings](LogLevel, std::string_view text) { warnings.value(text); };
    LoadOptions options;
    options.images = ImageForm::Encoded;
    const std::string name(inputText(nameSize));
    Result<Scene> scene = loadGltf(input().subspan(std::min(nameSize, input().size())), name, options, log);
    if (!scene)
        return answer(scene.error());
    g_scene = *std::move(scene);
    Json json;
    json.begin('{');
    writeMeshes(json, log);
    writeInstances(json);
    writeTextures(json);
    writeBounds(json);
    warnings.end(']');
    json.key("warnings").raw(warnings.text());
    answer(json.end('}'));
}

/// A sky, of which the input holds the bytes: one that `bake` wrote, or .hdr and .hdre, which are filtered
/// first; or
/// {"error"}. faceSize: of the skybox, texels.
FRANKEN_EXPORT(loadSky) void loadSkyOfPage(int faceSize) {
    BakeOptions options;
    options.sun = true;
    options.skyboxSize = faceSize;
    Result<BakedSky> sky = decodeBakedSky(input());
    if (!sky && sky.error().what.find("does not start") != std::string::npos)
        sky = loadSky("the file", options);
    if (!sky)
        return answer(sky.error());
    g_sky = *std::move(sky);
    Json json;
    writeSky(json);
    answer(json);
}
