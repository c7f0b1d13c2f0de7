// SPDX-License-Identifier: MIT
// Is the demonstration model good glTF, and the same everywhere? A picture of it is a golden of the renderer.
#include "support/shell.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <vector>

#include <glm/glm.hpp>
#include <tiny_gltf.h>

namespace {

namespace fs = std::filesystem;

int run(const fs::path& out) { return std::system((MAKE_MODEL " \"" + out.string() + "\" 2>&1").c_str()); }

// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t fingerprint(const std::vector<unsigned char>& bytes) {
    std::uint64_t value = 14695981039346656037u;
    for (const unsigned char byte : bytes)
        value = (value ^ byte) * 1099511628211u;
    return value;
}

class MakeModel : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(run(folder / "urn.gltf"), 0);

        std::string error;
        std::string warning;
        tinygltf::TinyGLTF loader;
        const std::string path = (folder / "urn.gltf").string();
        ASSERT_TRUE(loader.LoadASCIIFromFile(&model, &error, &warning, path)) << error;
        EXPECT_EQ(error + warning, "");
    }

    const unsigned char* bytesAt(const tinygltf::Accessor& accessor, std::size_t element) const {
        const tinygltf::BufferView& view = model.bufferViews[accessor.bufferView];
        const std::size_t stride = accessor.ByteStride(view);
        return &model.buffers[view.buffer].data[view.byteOffset + accessor.byteOffset + element * stride];
    }

    // A float attribute of a mesh as vectors; empty if the mesh does not have it.
    template<typename Vector>
    std::vector<Vector> attribute(const tinygltf::Mesh& mesh, const std::string& name) const {
        const auto found = mesh.primitives[0].attributes.find(name);
        if (found == mesh.primitives[0].attributes.end())
            return {};
        const tinygltf::Accessor& accessor = model.accessors[found->second];
        EXPECT_EQ(accessor.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
        std::vector<Vector> values(accessor.count);
        for (std::size_t i = 0; i < values.size(); ++i)
            std::memcpy(&values[i], bytesAt(accessor, i), sizeof(Vector));
        return values;
    }

    std::vector<std::uint16_t> indices(const tinygltf::Mesh& mesh) const {
        const tinygltf::Accessor& accessor = model.accessors[mesh.primitives[0].indices];
        EXPECT_EQ(accessor.componentType, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
        std::vector<std::uint16_t> values(accessor.count);
        std::memcpy(values.data(), bytesAt(accessor, 0), accessor.count * sizeof values[0]);
        return values;
    }

    const tinygltf::Material& material(const std::string& name) const {
        for (const tinygltf::Material& candidate : model.materials)
            if (candidate.name == name)
                return candidate;
        throw std::out_of_range("no material " + name);
    }

    const fs::path folder = franken::test::emptyTestFolder();
    tinygltf::Model model;
};

TEST_F(MakeModel, WritesTheSameBytesTwice) {
    ASSERT_EQ(run(folder / "first.glb"), 0);
    ASSERT_EQ(run(folder / "second.glb"), 0);
    const std::string first = franken::test::readText(folder / "first.glb");
    EXPECT_TRUE(first == franken::test::readText(folder / "second.glb"));
    EXPECT_LT(first.size(), 1500000u);
}

TEST_F(MakeModel, OneFileHoldsWhatTheManyHold) {
    ASSERT_EQ(run(folder / "urn.glb"), 0);
    std::string error;
    std::string warning;
    tinygltf::Model single;
    tinygltf::TinyGLTF loader;
    ASSERT_TRUE(loader.LoadBinaryFromFile(&single, &error, &warning, (folder / "urn.glb").string())) << error;
    EXPECT_EQ(error + warning, "");
    EXPECT_EQ(single.meshes, model.meshes);
    EXPECT_EQ(single.nodes, model.nodes);
    EXPECT_EQ(single.materials, model.materials);
    EXPECT_EQ(single.accessors, model.accessors);
    ASSERT_EQ(single.images.size(), model.images.size());
    for (std::size_t i = 0; i < single.images.size(); ++i)
        EXPECT_TRUE(single.images[i].image == model.images[i].image) << single.images[i].name;
}

TEST_F(MakeModel, SaysWhatItCannotWrite) {
    EXPECT_NE(run(folder / "no such folder" / "urn.gltf"), 0);
    EXPECT_NE(run("--unknown"), 0);
}

TEST_F(MakeModel, BoundsAreExact) {
    for (const tinygltf::Mesh& mesh : model.meshes) {
        const auto positions = attribute<glm::vec3>(mesh, "POSITION");
        ASSERT_FALSE(positions.empty());
        glm::vec3 low = positions[0];
        glm::vec3 high = positions[0];
        for (const glm::vec3& position : positions) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
        const auto& accessor = model.accessors[mesh.primitives[0].attributes.at("POSITION")];
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(accessor.minValues[axis], double(low[axis])) << mesh.name;
            EXPECT_EQ(accessor.maxValues[axis], double(high[axis])) << mesh.name;
        }
    }
}

TEST_F(MakeModel, TrianglesFaceOutwards) {
    std::size_t triangles = 0;
    for (const tinygltf::Mesh& mesh : model.meshes) {
        const auto positions = attribute<glm::vec3>(mesh, "POSITION");
        const auto normals = attribute<glm::vec3>(mesh, "NORMAL");
        const auto corners = indices(mesh);
        ASSERT_EQ(corners.size() % 3, 0u);
        for (const std::uint16_t corner : corners)
            ASSERT_LT(corner, positions.size());
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const glm::vec3 a = positions[corners[i]];
            const glm::vec3 facing = glm::cross(positions[corners[i + 1]] - a, positions[corners[i + 2]] - a);
            for (std::size_t k = i; k < i + 3; ++k)
                ASSERT_GT(glm::dot(facing, normals[corners[k]]), 0.0f) << mesh.name << ' ' << i / 3;
        }
        triangles += corners.size() / 3;
    }
    EXPECT_GT(triangles, 10000u);
    EXPECT_LT(triangles, 30000u);
}

TEST_F(MakeModel, TangentsFollowTheTexture) {
    for (const tinygltf::Mesh& mesh : model.meshes) {
        const auto positions = attribute<glm::vec3>(mesh, "POSITION");
        const auto normals = attribute<glm::vec3>(mesh, "NORMAL");
        const auto tangents = attribute<glm::vec4>(mesh, "TANGENT");
        const auto uvs = attribute<glm::vec2>(mesh, "TEXCOORD_0");
        const bool hasNormalMap = model.materials[mesh.primitives[0].material].normalTexture.index >= 0;
        ASSERT_EQ(tangents.size(), hasNormalMap ? positions.size() : 0u) << mesh.name;
        ASSERT_EQ(uvs.size(), tangents.size()) << mesh.name;

        for (const glm::vec3& normal : normals)
            ASSERT_NEAR(glm::length(normal), 1.0f, 1e-3f);
        for (std::size_t i = 0; i < tangents.size(); ++i) {
            ASSERT_NEAR(glm::length(glm::vec3(tangents[i])), 1.0f, 1e-3f);
            ASSERT_NEAR(glm::dot(glm::vec3(tangents[i]), normals[i]), 0.0f, 1e-3f);
            ASSERT_EQ(std::abs(tangents[i].w), 1.0f);
            ASSERT_TRUE(glm::all(glm::greaterThanEqual(uvs[i], glm::vec2(0.0f))));
            ASSERT_TRUE(glm::all(glm::lessThanEqual(uvs[i], glm::vec2(1.0f))));
        }
        if (!hasNormalMap)
            continue;

        // On each triangle, u grows along the tangent, and v falls along the bitangent: glTF counts v
        // downwards and lets green point up.
        const auto corners = indices(mesh);
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const std::uint16_t a = corners[i];
            const glm::mat2 byUv(uvs[corners[i + 1]] - uvs[a], uvs[corners[i + 2]] - uvs[a]);
            const glm::mat2x3 byPosition(positions[corners[i + 1]] - positions[a],
                                         positions[corners[i + 2]] - positions[a]);
            const glm::mat2x3 gradient = byPosition * glm::inverse(byUv);
            const glm::vec3 tangent(tangents[a]);
            const glm::vec3 bitangent = glm::cross(normals[a], tangent) * tangents[a].w;
            ASSERT_GT(glm::dot(glm::normalize(gradient[0]), tangent), 0.7f) << mesh.name << ' ' << i / 3;
            ASSERT_LT(glm::dot(glm::normalize(gradient[1]), bitangent), -0.7f) << mesh.name << ' ' << i / 3;
        }
    }
}

TEST_F(MakeModel, UsesEachKindOfTexture) {
    const tinygltf::Material& porcelain = material("porcelain");
    EXPECT_GE(porcelain.pbrMetallicRoughness.baseColorTexture.index, 0);
    EXPECT_GE(porcelain.normalTexture.index, 0);
    EXPECT_GE(porcelain.emissiveTexture.index, 0);
    EXPECT_GE(porcelain.occlusionTexture.index, 0);
    EXPECT_EQ(porcelain.occlusionTexture.index,
              porcelain.pbrMetallicRoughness.metallicRoughnessTexture.index);

    const tinygltf::Material& stone = material("stone");
    EXPECT_GE(stone.occlusionTexture.index, 0);
    EXPECT_EQ(stone.pbrMetallicRoughness.metallicRoughnessTexture.index, -1);
    EXPECT_EQ(stone.pbrMetallicRoughness.metallicFactor, 0.0);

    EXPECT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(model.lights.size(), 2u);
}

// The bytes that the goldens of the renderer rest on. Images are compared decoded, so that another version
// of the PNG writer may pack them otherwise. Whoever changes the model on purpose puts the new numbers here.
TEST_F(MakeModel, IsTheModelOfTheGoldens) {
    const std::map<std::string, std::uint64_t> expected{
        {"porcelain_base_colour", 0x272c2ac141b2be49u},
        {"porcelain_emissive", 0x11e208b4c4d38c69u},
        {"porcelain_normal", 0x11b66b3cb5c06732u},
        {"porcelain_occlusion_roughness_metallic", 0xa89f049089790531u},
        {"stone_base_colour", 0x3e6af94f4efd24beu},
        {"stone_normal", 0x00a8b2f763d039deu},
        {"stone_occlusion", 0xe52c07a7a6af9f81u},
        {"vertices and indices", 0xe17dd99af118379cu},
    };
    std::map<std::string, std::uint64_t> actual{{"vertices and indices", fingerprint(model.buffers[0].data)}};
    for (const tinygltf::Image& image : model.images)
        actual[image.name] = fingerprint(image.image);
    EXPECT_EQ(actual, expected);
}

} // namespace
