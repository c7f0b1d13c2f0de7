// SPDX-License-Identifier: MIT
#pragma once

#include "franken/viewpoint.h"
#include "models.h"

#include <optional>
#include <vector>

namespace franken {

/// A drawable of a model that is shown: all that a frame reads of it, in one place.
struct Object {
    ObjectBlock block;
    std::uint64_t serial = 0; ///< Of the block.
    Bounds bounds;
    glm::dvec3 position; ///< Of its origin, in the world.
    const GpuMesh* mesh;
    const GpuMaterial* material;
    unsigned order; ///< By model, material and mesh.
    bool mirrored, doubleSided;
    bool visible = false;
};

/// The objects of all models that are shown, in their order of drawing.
class DrawList {
public:
    /// Of these models, which must outlive the list or be removed from it by another rebuild().
    void rebuild(const std::vector<Model*>& shown);
    void clear() { rebuild({}); }

    /// By program, material and mesh; after programs have changed.
    void sort();

    /// Places all objects for that view, unless they are placed for it already.
    void place(const Viewpoint& viewpoint);

    const std::vector<Object>& opaque() const { return m_opaque; } ///< Visible ones and others.
    const std::vector<const Object*>& backToFront() const {
        return m_backToFront;
    } ///< Blended and visible ones.

    /// The distance from the eye that no corner of a visible object's bounds exceeds.
    double farthest(const glm::dvec3& eye) const;

    std::size_t visible() const { return m_visible; }
    std::size_t size() const { return m_opaque.size() + m_blended.size(); }

private:
    void add(const GpuScene& scene);

    std::vector<Object> m_opaque, m_blended;
    std::vector<const Object*> m_backToFront;
    std::optional<Viewpoint> m_placedFor;
    std::size_t m_visible = 0;
};

} // namespace franken
