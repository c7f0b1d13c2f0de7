// SPDX-License-Identifier: MIT
#pragma once

#include "franken/viewpoint.h"
#include "models.h"
#include "object_block.h"

#include <optional>
#include <vector>

namespace franken {

/// A drawable of a model that is shown, at one of its places: all that a frame reads of it.
struct Object {
    ObjectBlock block = {};
    std::uint64_t serial = 0; ///< Of the block.
    Bounds bounds = {};
    glm::dvec3 position{0.0}; ///< Of its origin, in the world.
    const Place* place;
    const Drawable* drawable;
    const GpuPrimitive* primitive;
    GpuMesh* mesh;
    GpuMaterial* material;
    unsigned order;                   ///< By model, material and mesh.
    unsigned group = 0;               ///< Of opaque objects of one program; groups in their order of drawing.
    unsigned movements = 0;           ///< Those of its place that the members above are for.
    Palette palette = {};             ///< Of a skin.
    std::uint64_t paletteSerial = 0;  ///< Of the palette of the mesh's first part; the others' follow.
    const PosedMesh* posed = nullptr; ///< What is drawn in place of the mesh; may be null.
    bool isPlaced = false;            ///< They are for any, and for the sky's rotation.
    bool mirrored = false;
    bool visible = false;
};

/// Whether the place has a pose that can deform the object.
inline bool isPosed(const Object& object) {
    return object.primitive->deformation && !object.place->nodes.empty() &&
           object.drawable->nodeIndex != kNone;
}

/// Whether the object's program moves its vertices to where their joints are.
bool isSkinnedByProgram(const Object& object);

/// What its pose, or rest, makes of its vertices.
Deforming deformingOf(const Object& object);

/// The objects of all models that are shown, in their order of drawing.
class DrawList {
public:
    /// Of these models, which must outlive the list or be removed from it by another rebuild().
    void rebuild(const std::vector<Model*>& shown);
    void clear() { rebuild({}); }

    /// By program, material and mesh; after programs have changed.
    void sort();

    /// Places all objects for that view, unless they are placed for it already. `movements`: another number
    /// after each change of a place.
    void place(const PlacedView& view, unsigned movements);

    /// Of the objects, each once.
    const std::vector<GpuMaterial*>& materials() const { return m_materials; }

    /// An opaque object that is visible, by how deep it lies among those: slice 0 is the nearest.
    struct Layer {
        const Object* object;
        int slice;
    };
    /// Program by program, masked ones last; of a program the nearest slice first, and within a slice by
    /// material and mesh.
    const std::vector<Layer>& frontToBack() const { return m_frontToBack; }
    const std::vector<const Object*>& backToFront() const {
        return m_backToFront;
    } ///< Blended and visible ones.

    /// The distance from the eye that no corner of a visible object's bounds exceeds.
    double farthest(const glm::dvec3& eye) const;

    /// Calls the function with each visible object whose vertices a pose can move.
    template<typename Function>
    void forEachDeformed(Function function) {
        if (m_canDeform)
            for (std::vector<Object>* objects : {&m_opaque, &m_blended})
                for (Object& object : *objects)
                    if (object.visible && object.primitive->deformation)
                        function(object);
    }

    std::size_t visible() const { return m_visible; }
    std::size_t size() const { return m_opaque.size() + m_blended.size(); }

private:
    void add(Model& model);
    void sortFrontToBack(const Viewpoint& viewpoint);
    bool placeOne(Object& object, const Frustum& frustum, const glm::dmat4& skyToClip);

    std::vector<Object> m_opaque, m_blended;
    std::vector<GpuMaterial*> m_materials;
    std::vector<const Object*> m_backToFront;
    std::vector<Layer> m_frontToBack;
    std::optional<PlacedView> m_placedFor;
    unsigned m_movements = 0;
    bool m_canDeform = false; ///< One of the objects can.
    std::uint64_t m_nextSerial = 0;
    std::size_t m_visible = 0;
};

} // namespace franken
