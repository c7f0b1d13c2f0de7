// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// A glTF file in the making: JSON at hand as `json`, and buffer 0 filled by the functions below.
class GltfBuilder {
public:
    using Json = nlohmann::json;

    /// Types of the components, as glTF numbers them.
    static constexpr int kByte = 5120, kUByte = 5121, kShort = 5122, kUShort = 5123, kUInt = 5125,
                         kFloat = 5126;

    Json json{{"asset", {{"version", "2.0"}}}};

    /// Appends a buffer view with these values, `stride` bytes declared (0: none); its index.
    template<typename T>
    int view(const std::vector<T>& values, int stride = 0) {
        const std::size_t offset = (m_bytes.size() + 3) / 4 * 4;
        m_bytes.resize(offset + values.size() * sizeof(T));
        if (!values.empty())
            std::memcpy(m_bytes.data() + offset, values.data(), values.size() * sizeof(T));
        Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}};
        if (stride)
            view["byteStride"] = stride;
        return append("bufferViews", view);
    }

    /// Appends an accessor of all of a new view; its index.
    template<typename T>
    int accessor(const char* type, int componentType, const std::vector<T>& values, bool normalized = false) {
        const int width = std::string(type) == "SCALAR" ? 1
                          : std::string(type) == "MAT4" ? 16
                                                        : type[3] - '0';
        Json accessor{{"bufferView", view(values)},
                      {"componentType", componentType},
                      {"count", static_cast<int>(values.size()) / width},
                      {"type", type}};
        if (normalized)
            accessor["normalized"] = true;
        return append("accessors", accessor);
    }
    int floats(const char* type, const std::vector<float>& values) { return accessor(type, kFloat, values); }

    /// Appends to an array of the document; the index.
    int append(const char* array, const Json& object);

    /// One mesh with one primitive in one node in one scene.
    void setPrimitive(const Json& primitive);
    /// The unit triangle (0,0,0), (1,0,0), (0,1,0), and setPrimitive() of it.
    void setTriangle();
    /// A unit triangle for each of these image files, which it shows.
    void setTriangles(const std::vector<std::vector<unsigned char>>& images, const char* mimeType);
    /// Appends a PNG of one pixel, with an image, texture and sampler-less use of it; the texture's index.
    int appendTexture();

    /// The whole file: a .glb, or a .gltf with its buffer inside.
    std::string bytes(bool binary) const;

private:
    std::vector<unsigned char> m_bytes;
};

/// A .glb of a JSON text and a binary chunk, padded as glTF has it.
std::string glb(const std::string& json, const std::string& data);

std::string base64(const std::vector<unsigned char>& bytes);
