// SPDX-License-Identifier: MIT
// The detour of the checked JSON through tinygltf: made into what it accepts, written out, parsed, and what
// was put in for it alone taken back.
#include <algorithm>

#include "gltf/document.h"

namespace franken::gltf {
namespace {

/// A mapping is an object of an object's array, and tinygltf makes a Value of each number in it.
bool chargeVariants(Source& source, const Json& primitive, const std::string& where) {
    for (const Json& mapping :
         member(member(member(primitive, "extensions"), "KHR_materials_variants"), "mappings"))
        if (!source.charge(member(mapping, "variants").size() + 4, 3 * sizeof(tinygltf::Value), where))
            return false;
    return true;
}

// tinygltf's objects are much larger than what JSON says of them, and its arrays grow by doubling: for a
// moment there are up to three places for each element.
bool chargeObjects(Source& source, const Json& root) {
    const auto charge = [&](const Json& array, std::size_t bytes, const std::string& where) {
        return source.charge(array.size(), 3 * bytes, where);
    };
    const Json& nodes = member(root, "nodes");
    const auto instances = static_cast<std::size_t>(
        std::count_if(nodes.begin(), nodes.end(), [](const Json& node) { return node.contains("mesh"); }));
    const Json& lights = member(member(member(root, "extensions"), "KHR_lights_punctual"), "lights");
    for (const Json& mesh : member(root, "meshes")) {
        if (!charge(mesh["primitives"], sizeof(tinygltf::Primitive), "/meshes"))
            return false;
        for (const Json& primitive : mesh["primitives"])
            if (!chargeVariants(source, primitive, "/meshes"))
                return false;
    }
    const Json& variants = member(member(member(root, "extensions"), "KHR_materials_variants"), "variants");
    return charge(variants, 3 * sizeof(tinygltf::Value) + sizeof(std::string),
                  "/extensions/KHR_materials_variants") &&
           charge(member(root, "buffers"), sizeof(tinygltf::Buffer) + sizeof(Buffer), "/buffers") &&
           charge(member(root, "bufferViews"), sizeof(tinygltf::BufferView), "/bufferViews") &&
           charge(member(root, "accessors"), sizeof(tinygltf::Accessor), "/accessors") &&
           charge(member(root, "images"), sizeof(tinygltf::Image) + sizeof(EncodedImage), "/images") &&
           charge(member(root, "samplers"), sizeof(tinygltf::Sampler), "/samplers") &&
           charge(member(root, "textures"), sizeof(tinygltf::Texture), "/textures") &&
           charge(member(root, "materials"),
                  sizeof(tinygltf::Material) + sizeof(Material) + sizeof(MaterialValues), "/materials") &&
           charge(member(root, "meshes"), sizeof(tinygltf::Mesh), "/meshes") &&
           charge(member(root, "skins"), sizeof(tinygltf::Skin), "/skins") &&
           charge(member(root, "cameras"), sizeof(tinygltf::Camera), "/cameras") &&
           charge(member(root, "nodes"), sizeof(tinygltf::Node), "/nodes") &&
           source.charge(instances, sizeof(Instance), "/nodes") && // reserved
           charge(member(root, "scenes"), sizeof(tinygltf::Scene), "/scenes") &&
           charge(lights, sizeof(tinygltf::Light), "/extensions/KHR_lights_punctual/lights");
}

std::string takeString(Json& object, const char* key) {
    return object.contains(key) ? std::move(object[key].get_ref<std::string&>()) : std::string();
}

// Notes where buffers and images come from, and gives tinygltf a byte for each, so that it opens no file,
// decodes no text and looks into no buffer.
bool takeResources(Source& source, Json& root) {
    const char* const kOneByte = "data:application/octet-stream;base64,AA==";
    for (Json& buffer : root["buffers"]) {
        const auto length = buffer["byteLength"].get<std::size_t>();
        const bool hasUri = buffer.contains("uri");
        source.buffers.push_back({takeString(buffer, "uri"), hasUri, length, {}, {}, {}});
        buffer = {{"byteLength", 1}, {"uri", kOneByte}};
    }
    for (Json& image : root["images"]) {
        const std::string where = pathOf("images", source.images.size());
        if (image.contains("bufferView") == image.contains("uri")) {
            source.fail("gltf.schema", where, "an image has either a buffer view or a URI");
            if (!source.defer(where))
                return false;
        }
        source.images.push_back(
            {takeString(image, "name"), takeString(image, "uri"), image.value("bufferView", kNone), {}, {}});
        image = {{"uri", kOneByte}};
    }
    return true;
}

// Where textures and factors stand is in the tables of their roles and rows; tinygltf has a member for each.
void noteMaterials(Document& source, const Json& root) {
    for (const Json& material : member(root, "materials")) {
        MaterialValues& values = source.materials.emplace_back();
        const auto find = [&](std::string_view gltf) {
            const Json::json_pointer place{std::string(gltf)};
            return !gltf.empty() && material.contains(place) ? material.at(place) : Json();
        };
        for (const TextureRoleRow& role : textureRoles())
            if (isMaterials(role.role))
                values.textures[static_cast<std::size_t>(role.role)] = find(role.gltf);
        for (std::size_t i = 0; i < values.factors.size(); ++i)
            if (const Json found = find(kMaterialFactors[i].gltf); found.is_number())
                values.factors[i] = {found.get<double>()};
            else if (found.is_array())
                values.factors[i] = found.get<std::vector<double>>();
    }
}

// Strides that tinygltf would refuse have one meaning; what they have to be is checked with the accessors.
void takeStrides(Source& source, Json& root) {
    for (Json& view : root["bufferViews"]) {
        source.strides.push_back(view.value("byteStride", std::size_t{0}));
        view.erase("byteStride");
    }
}

// tinygltf leaves empty objects out of arrays, and the next variant would come to bear its number.
void nameVariants(Json& root) {
    if (member(member(root, "extensions"), "KHR_materials_variants").contains("variants"))
        for (Json& variant : root["extensions"]["KHR_materials_variants"]["variants"])
            variant.emplace("name", "");
}

// tinygltf refuses indices without a view, which glTF allows (they are zero); it gets one that is taken back.
int addPlaceholderView(Json& root) {
    const int placeholder = static_cast<int>(root["bufferViews"].size());
    for (Json& accessor : root["accessors"])
        if (!accessor.contains("bufferView"))
            accessor["bufferView"] = placeholder;
    root["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 1}});
    return placeholder;
}

// Image bytes are read, and decoded, elsewhere.
bool ignoreImage(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                 void*) {
    return true;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

bool parse(Document& source, const std::string& text) {
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(ignoreImage, nullptr);
    std::string errors, warnings;
    if (!parser.LoadASCIIFromString(&source.model, &errors, &warnings, text.data(),
                                    static_cast<unsigned int>(text.size()), ""))
        return source.fail("gltf.json", "", "the parser refuses the file: " + firstLine(errors));
    // tinygltf takes inverse bind matrices to be required; glTF does not.
    if (!errors.empty() && errors.find("inverseBindMatrices") == std::string::npos)
        source.warn(kLeftOut, "", "the parser left something out: " + firstLine(errors));
    return true;
}

} // namespace

bool parseModel(Document& source, Json& root) {
    if (!chargeObjects(source, root) || !takeResources(source, root))
        return false;
    noteMaterials(source, root);
    takeStrides(source, root);
    if (root.contains("animations"))
        source.animations = std::move(root["animations"]);
    root.erase("animations");
    nameVariants(root);
    const int placeholder = addPlaceholderView(root);
    const std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    root = {};
    if (!parse(source, text))
        return false;
    source.model.bufferViews.pop_back();
    for (tinygltf::Accessor& accessor : source.model.accessors)
        if (accessor.bufferView == placeholder)
            accessor.bufferView = kNone;
    return true;
}

} // namespace franken::gltf
