// SPDX-License-Identifier: MIT
#pragma once

#include "equal_data.h"
#include "gpu_scene.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace franken {

/// A scene, what stays of it, and the context that it is for.
struct SceneInput {
    std::shared_ptr<const Scene> scene;
    Outline outline; ///< Its materials perhaps changed since.
    Capabilities capabilities;
    Log log;
};

/// What is drawn of a scene, and what is uploaded for that: geometry that is equal, and images that are equal
/// and sampled alike, once.
struct ScenePlan {
    struct PlannedTexture {
        SampledImage sampled;
        std::array<std::uint8_t, 4> defaultTexel; ///< Where the image cannot be decoded.
    };
    GpuScene gpu; ///< Without textures and meshes.
    std::vector<const Primitive*> meshes;
    std::vector<PlannedTexture> textures;
};

/// A mesh or a texture, as GL takes it.
using Piece = std::variant<std::vector<MeshPart>, TextureData>;
std::size_t bytesOf(const Piece& piece);

/// A scene as pieces for the GPU. Needs no GL, and may be used on any thread.
class SceneData {
public:
    /// Fails as check(scene).
    static Result<SceneData> make(SceneInput input);

    /// The next piece: all meshes, then all textures; nothing at the end. An image that cannot be decoded is
    /// a warning, and a texel that changes nothing.
    std::optional<Piece> next();
    const Outline& outline() const { return m_input.outline; }
    GpuScene takePlan() { return std::move(m_plan.gpu); }

private:
    SceneData(SceneInput input, ScenePlan plan) : m_input(std::move(input)), m_plan(std::move(plan)) {}
    TextureData textureAt(std::size_t index);
    /// Of the normal map that is being made, for all textures that will be made with it.
    void keepSpreads(std::size_t normals, const Image& image);
    void widen(TextureData& data, std::size_t index);

    SceneInput m_input;
    ScenePlan m_plan;
    std::size_t m_mesh = 0, m_texture = 0;
    /// By ScenePlan::textures and scale: of normal maps, until the last texture that needs them is made.
    std::map<std::pair<std::size_t, float>, NormalSpread> m_spreads;
};

/// The pieces of a scene on their way to the GPU.
class SceneUpload {
public:
    bool isIdle() const { return std::holds_alternative<std::monostate>(m_current); }
    /// Only where it is idle. Fails with "memory.budget" and with "gl.object".
    Result<void> begin(Device& device, Piece piece);
    /// A part of the piece; how many bytes it has. Only where it is not idle. Fails likewise.
    Result<std::size_t> step(Device& device, std::size_t maxBytes = ~std::size_t{0});
    /// The whole, when all pieces were uploaded.
    GpuScene finish(GpuScene plan, const DefaultTextures& defaults);

private:
    std::vector<GpuMesh> m_meshes;
    std::vector<GpuTexture> m_textures;
    std::variant<std::monostate, MeshUpload, TextureUpload> m_current;
};

/// All at once. Fails as SceneData and SceneUpload do.
Result<GpuScene> upload(Device& device, SceneInput input, const DefaultTextures& defaults);

} // namespace franken
