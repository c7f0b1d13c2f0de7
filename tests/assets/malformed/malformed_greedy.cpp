// SPDX-License-Identifier: MIT
#include <functional>

#include "malformed/malformed.h"
#include "malformed/pictures.h"

namespace {

using Json = GltfBuilder::Json;

std::string repeated(const std::string& text, int count) {
    std::string out;
    out.reserve(text.size() * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        out += text;
    return out;
}

/// A file with `count` times `object` in the array `name`.
MalformedFile many(const std::string& what, const std::string& name, const std::string& object, int count,
                   const std::string& code) {
    return {"greedy/" + what, "gltf",
            R"({"asset":{"version":"2.0"},")" + name + "\":[" + repeated(object + ",", count - 1) + object +
                "]}",
            code};
}

MalformedFile changed(const std::string& what, const std::function<void(GltfBuilder&)>& change,
                      const std::string& code = "gltf.limit") {
    GltfBuilder file = soundModel();
    change(file);
    return {"greedy/" + what, "glb", file.bytes(true), code};
}

Json zeros(std::size_t count, const char* type) {
    return {{"componentType", GltfBuilder::kFloat}, {"count", count}, {"type", type}};
}

/// A triangle of these accessors without bytes, drawn by `primitives` primitives.
MalformedFile bare(const std::string& what, std::size_t vertices, int primitives, int mode,
                   const std::string& code) {
    GltfBuilder file;
    file.setPrimitive(
        {{"attributes", {{"POSITION", file.append("accessors", zeros(vertices, "VEC3"))}}}, {"mode", mode}});
    const Json primitive = file.json["meshes"][0]["primitives"][0];
    for (int i = 1; i < primitives; ++i)
        file.json["meshes"][0]["primitives"].push_back(primitive);
    return {"greedy/" + what, "gltf", file.bytes(false), code};
}

/// Textures of these images, each used by a material.
MalformedFile gallery(const std::string& what, const std::string& picture, int images,
                      const std::string& code) {
    GltfBuilder file;
    file.setTriangle();
    const int view = file.view(std::vector<char>(picture.begin(), picture.end()));
    for (int i = 0; i < images; ++i) {
        file.append("images", {{"mimeType", "image/png"}, {"bufferView", view}});
        file.append("textures", {{"source", i}});
        file.append("materials", {{"emissiveTexture", {{"index", i}}}});
        Json primitive = file.json["meshes"][0]["primitives"][0];
        primitive["material"] = i;
        file.json["meshes"][0]["primitives"].push_back(primitive);
    }
    return {"greedy/" + what, "glb", file.bytes(true), code};
}

/// One triangle again and again, each time with tangents of its own.
MalformedFile sameTriangle(int count) {
    GltfBuilder file = soundModel();
    std::vector<unsigned char> indices;
    for (int i = 0; i < count; ++i)
        indices.insert(indices.end(), {0, 1, 2});
    Json& primitive = file.json["meshes"][0]["primitives"][0];
    primitive["attributes"].erase("TANGENT");
    primitive["indices"] = file.accessor("SCALAR", GltfBuilder::kUByte, indices);
    return {"greedy/one-triangle-" + std::to_string(count) + "-times", "glb", file.bytes(true), ""};
}

std::vector<MalformedFile> greedyJson() {
    return {
        many("1500000-numbers", "extras", "0", 1500000, ""),
        many("4-million-numbers", "extras", "0", 4000000, "gltf.limit"),
        many("a-million-arrays", "extras", "[]", 1000000, ""),
        many("a-million-objects-with-members", "extras", R"({"a":{"b":0}})", 1000000, "gltf.limit"),
        many("a-million-materials", "materials", "{}", 1000000, "gltf.limit"),
        many("200000-nodes", "nodes", "{}", 200000, "gltf.limit"),
        many("50000-nodes", "nodes", "{}", 50000, ""),
        many("200000-cameras", "cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":1}})",
             200000, "gltf.limit"),
        many("a-million-scenes", "scenes", "{}", 1000000, "gltf.limit"),
        many("a-million-empty-primitives", "meshes",
             R"({"primitives":[{"attributes":{}},{"attributes":{}}]})", 500000, "gltf.limit"),
        {"greedy/a-string-of-55-million", "gltf",
         R"({"asset":{"version":"2.0"},"extras":")" + std::string(55000000, 'x') + "\"}", ""},
        {"greedy/a-string-of-80-million", "gltf",
         R"({"asset":{"version":"2.0"},"extras":")" + std::string(80000000, 'x') + "\"}", "gltf.limit"},
        {"greedy/a-key-of-a-million", "gltf",
         R"({"asset":{"version":"2.0"},")" + std::string(1000000, 'x') + "\":0}", ""},
        {"greedy/a-chain-of-30000-nodes", "gltf",
         [] {
             std::string nodes;
             for (int i = 1; i < 30000; ++i)
                 nodes += "{\"children\":[" + std::to_string(i) + "]},";
             return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "{}]}";
         }(),
         ""},
    };
}

std::vector<MalformedFile> greedyMeshes() {
    return {
        bare("a-billion-vertices-without-bytes", 1000000000, 1, 4, "gltf.limit"),
        bare("3-million-vertices-without-bytes", 3000000, 1, 4, "gltf.limit"),
        bare("half-a-million-vertices-without-bytes", 500000, 1, 4, ""),
        bare("half-a-million-vertices-10-times", 500000, 10, 4, "gltf.limit"),
        bare("a-strip-of-a-million-vertices", 1000000, 1, 5, "gltf.limit"),
        sameTriangle(30000),
        changed("100-targets-of-a-million-vertices",
                [](GltfBuilder& file) {
                    Json& primitive = file.json["meshes"][0]["primitives"][0];
                    const int positions = file.append("accessors", zeros(1000000, "VEC3"));
                    primitive = {{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}}};
                    primitive["targets"] = Json(100, Json{{"POSITION", positions}, {"NORMAL", positions}});
                    file.json["nodes"][0]["weights"] = Json(100, 1);
                    file.json["nodes"][0].erase("skin");
                }),
        changed("a-morph-of-a-million-corners-at-500-nodes",
                [](GltfBuilder& file) {
                    Json& primitive = file.json["meshes"][0]["primitives"][0];
                    const int positions = file.append("accessors", zeros(3, "VEC3"));
                    primitive = {{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}}};
                    primitive["targets"] = {{{"POSITION", positions}}};
                    primitive["indices"] =
                        file.accessor("SCALAR", GltfBuilder::kUByte, std::vector<unsigned char>(1000000, 0));
                    file.json["nodes"] = Json(500, Json{{"mesh", 0}});
                    file.json["scenes"][0]["nodes"] = Json::array();
                    for (int i = 0; i < 500; ++i)
                        file.json["scenes"][0]["nodes"].push_back(i);
                    file.json["extensions"].clear();
                }),
        changed("2000-skins-of-4000-joints",
                [](GltfBuilder& file) {
                    file.json["skins"] = {{{"joints", Json(4000, 0)}}};
                    file.json["nodes"] = Json(2000, Json{{"mesh", 0}, {"skin", 0}});
                    file.json["scenes"][0]["nodes"] = Json::array();
                    for (int i = 0; i < 2000; ++i)
                        file.json["scenes"][0]["nodes"].push_back(i);
                    file.json["extensions"].clear();
                }),
        changed("a-million-matrices-without-bytes",
                [](GltfBuilder& file) {
                    file.json["skins"][0]["inverseBindMatrices"] =
                        file.append("accessors", zeros(4000000, "MAT4"));
                }),
        changed(
            "accessor-of-2-billion-nobody-reads",
            [](GltfBuilder& file) { file.append("accessors", zeros(2000000000, "MAT4")); }, ""),
    };
}

std::vector<MalformedFile> greedyImages() {
    return {
        gallery("an-image-of-8192-x-8192", pictures::png(8192, 8192), 1, "gltf.limit"),
        gallery("an-image-of-4096-x-4096", pictures::png(4096, 4096, 8, 6), 1, ""),
        gallery("an-image-of-4096-x-4096-and-16-bits", pictures::png(4096, 4096, 16, 6), 1, "gltf.limit"),
        gallery("a-jpeg-of-4096-x-4096", pictures::jpeg(4096, 4096), 1, ""),
        gallery("a-jpeg-of-4096-x-4096-in-100-scans", pictures::jpeg(4096, 4096, true, 100), 1, ""),
        gallery("one-image-of-1024-x-1024-50-times", pictures::png(1024, 1024), 50, ""),
        gallery("one-image-of-1024-x-1024-1000-times", pictures::png(1024, 1024), 1000, "gltf.limit"),
        gallery("one-broken-image-1000-times", pictures::png(1024, 1024).substr(0, 6000), 1000, "gltf.limit"),
    };
}

} // namespace

std::vector<MalformedFile> greedyFiles() {
    std::vector<MalformedFile> all = greedyJson();
    for (const auto& group : {greedyMeshes(), greedyImages()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

std::vector<MalformedFile> malformedFiles() {
    std::vector<MalformedFile> all;
    for (const auto& group : {malformedContainers(), malformedJson(), malformedSchemas(), malformedData(),
                              malformedUris(), malformedImages(), greedyFiles(), malformedSkies()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}
