// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/pose.h"
#include "franken/result.h"
#include "franken/scene.h"

#include <limits>
#include <memory>
#include <optional>
#include <span>

/// What a ray meets in a scene: what somebody points at. On the CPU, in double precision.
namespace FRANKEN_API franken {

/// A half-line, or a part of one.
struct Ray {
    glm::dvec3 origin{0.0};                                  ///< World space, m.
    glm::dvec3 direction{0, 0, -1};                          ///< World space; any length but 0.
    double length = std::numeric_limits<double>::infinity(); ///< m, > 0; what lies beyond is not met.
};

/// The ray with a direction of length 1, however long or short it was. Fails with "pick.ray" for an origin or
/// direction that is not finite, a direction of no length, and a length that is not above 0.
Result<Ray> normalized(Ray ray);

/// Where a ray first meets a surface.
struct Hit {
    int instance = kNone;        ///< Index into Scene::instances, whose names are those of nodes.
    int primitive = kNone;       ///< Index into the primitives of the instance's mesh.
    int material = kNone;        ///< Index into Scene::materials, in the variant that was asked for.
    int triangle = kNone;        ///< Its corners are indices[3 * triangle] and the two that follow.
    glm::dvec3 barycentric{0.0}; ///< Shares of the three corners in the point; each 0-1, their sum is 1.
    glm::dvec3 point{0.0};       ///< World space, m.
    double distance = 0.0;       ///< From the ray's origin, m.
};

/// What an application has changed of a scene since its tree was made.
struct PickOptions {
    int variant = kNone; ///< Index into Scene::variants, or kNone: the materials without a variant.
    std::span<const Material> materials = {}; ///< In place of all of the scene's; empty: the scene's.
    /// Where things are in place of where the scene had them when the tree was made, and what worldsOf() says
    /// of that pose: both, or neither.
    const Pose* pose = nullptr;
    const std::vector<NodeWorld>* nodes = nullptr; ///< See `pose`.
};

/// A scene in a form in which rays find triangles fast: a tree of boxes for each mesh (split at the median of
/// the triangles' centres along their widest extent), and one for the instances, which share the meshes'.
///
/// Met is what is drawn: front faces, and back faces of double-sided materials; triangles without area are
/// never met. Alpha is not looked at: where a mask or a texture makes a surface transparent, it is met.
/// Scenes hold triangles alone; loadGltf() made them of strips and fans, and left points and lines out.
/// Instances that their matrix presses flat are not met either. Two triangles that share an edge leave no gap
/// between them (S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", 2013).
///
/// Making one costs O(n log n) for n triangles of all meshes, and some 100 bytes for each; copies share
/// them. A pick costs O(log n) and allocates nothing. With a pose, it looks at each instance, and where a
/// skin or a morph moves vertices near the ray, it moves and tests all of that primitive, which allocates.
/// Safe on any thread, also for several picks at once.
class PickTree {
public:
    /// Does not need the scene afterwards. Fails as check(scene).
    static Result<PickTree> of(const Scene& scene);

    /// The nearest surface, or nothing. Fails as normalized(), and with "pick.options" for a variant that the
    /// scene does not have, and for another number of materials than it has.
    Result<std::optional<Hit>> pick(const Ray& ray, const PickOptions& options = {}) const;

    /// What the scene had: whether a tree is that of a scene.
    struct Counts {
        std::size_t triangles = 0; ///< Of all meshes, each counted once.
        /// How many a scene has.
        std::size_t instances = 0, materials = 0, variants = 0, nodes = 0;
        bool operator==(const Counts&) const = default;
    };
    const Counts& counts() const; ///< Those of the scene that the tree was made of.

private:
    struct Data;
    class Search;
    explicit PickTree(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

/// For one ray: makes a tree and throws it away, which takes as long as testing all triangles some 90 times.
/// Keep a tree for more rays. Fails as PickTree::of() and PickTree::pick().
Result<std::optional<Hit>> pick(const Scene& scene, const Ray& ray, const PickOptions& options = {});

} // namespace franken
