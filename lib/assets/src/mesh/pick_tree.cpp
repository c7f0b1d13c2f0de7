// SPDX-License-Identifier: MIT
#include "franken/pick.h"

#include "finite.h"
#include "franken/scene_check.h"
#include "mesh/box_tree.h"
#include "mesh/ray_triangle.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace franken {
namespace {

/// A primitive's triangles, in the order of its tree.
struct PickPrimitive {
    BoxTree tree;
    std::vector<Corners> corners;
    std::vector<int> materials; ///< Its own, and then one for each variant, if any.

    int materialIn(int variant) const {
        const auto place = static_cast<std::size_t>(variant + 1);
        return place < materials.size() && materials[place] != kNone ? materials[place] : materials.front();
    }
};

/// A primitive of an instance.
struct PickDrawable {
    int instance, primitive;
    std::size_t shared; ///< Index into PickTree::Data::primitives.
    glm::dmat4 world;
    glm::dmat3 inverse; ///< Of the world's upper left part.
    bool insideOut;     ///< What winds counter-clockwise in the world is not what counts as front.
};

Corners cornersOf(const Primitive& primitive, std::size_t triangle) {
    const std::uint32_t* const index = primitive.indices.data() + 3 * triangle;
    return {primitive.positions[index[0]], primitive.positions[index[1]], primitive.positions[index[2]]};
}

PickPrimitive prepare(const Primitive& primitive) {
    std::vector<Box> boxes(primitive.indices.size() / 3);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const glm::vec3& corner : cornersOf(primitive, i))
            boxes[i].add(glm::dvec3(corner));
    PickPrimitive prepared{BoxTree(boxes), {}, {primitive.material}};
    prepared.corners.reserve(boxes.size());
    for (const std::uint32_t triangle : prepared.tree.order())
        prepared.corners.push_back(cornersOf(primitive, triangle));
    prepared.materials.insert(prepared.materials.end(), primitive.variantMaterials.begin(),
                              primitive.variantMaterials.end());
    return prepared;
}

Error rayError(const char* where, const char* what) {
    return {"pick.ray", where, what, "pass another ray; rayThrough() makes one of a point of a picture"};
}

} // namespace

Result<Ray> normalized(Ray ray) {
    if (!isFinite(ray.origin))
        return rayError("origin", "its numbers must be finite");
    if (!isFinite(ray.direction))
        return rayError("direction", "its numbers must be finite");
    const glm::dvec3 size = glm::abs(ray.direction);
    const double largest = std::max({size.x, size.y, size.z});
    if (largest == 0)
        return rayError("direction", "it must have a length");
    if (!(ray.length > 0))
        return rayError("length", "it must be above 0");
    ray.direction = glm::normalize(ray.direction / largest);
    return ray;
}

struct PickTree::Data {
    std::vector<PickPrimitive> primitives; ///< In the order of the scene's meshes.
    std::vector<PickDrawable> drawables;   ///< In the order of `tree`.
    BoxTree tree{{}};                      ///< Of the drawables.
    std::vector<bool> doubleSided;         ///< By material.
    Counts counts;
};

namespace {

std::vector<PickDrawable> drawablesOf(const Scene& scene) {
    std::vector<std::size_t> first(scene.meshes.size(), 0); // Primitive of each mesh.
    for (std::size_t mesh = 1; mesh < first.size(); ++mesh)
        first[mesh] = first[mesh - 1] + scene.meshes[mesh - 1].primitives.size();
    std::vector<PickDrawable> drawables;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (!instance.visible)
            continue;
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        const glm::dmat3 linear(instance.world);
        const double determinant = glm::determinant(linear);
        if (determinant == 0)
            continue;
        for (std::size_t p = 0; p < scene.meshes[mesh].primitives.size(); ++p)
            drawables.push_back({static_cast<int>(i), static_cast<int>(p), first[mesh] + p, instance.world,
                                 glm::inverse(linear), instance.mirrored != (determinant < 0)});
    }
    return drawables;
}

} // namespace

Result<PickTree> PickTree::of(const Scene& scene) {
    if (Result<void> checked = check(scene); !checked)
        return checked.error();
    auto data = std::make_shared<Data>();
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            data->primitives.push_back(prepare(primitive));
    const std::vector<PickDrawable> drawables = drawablesOf(scene);
    std::vector<Box> boxes(drawables.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i].add(data->primitives[drawables[i].shared].tree.bounds(), drawables[i].world);
    data->tree = BoxTree(boxes);
    for (const std::uint32_t drawable : data->tree.order())
        data->drawables.push_back(drawables[drawable]);
    for (const Material& material : scene.materials)
        data->doubleSided.push_back(material.doubleSided);
    data->counts = {0, scene.instances.size(), scene.materials.size(), scene.variants.size()};
    for (const PickPrimitive& primitive : data->primitives)
        data->counts.triangles += primitive.corners.size();
    return PickTree(std::move(data));
}

/// The way of one ray through the trees.
class PickTree::Search {
public:
    Search(const Data& data, const Ray& ray, int variant, std::span<const Material> materials)
        : m_data(data), m_ray(ray), m_variant(variant), m_materials(materials), m_nearest(ray.length) {}

    std::optional<Hit> run() {
        m_data.tree.visit(RayInverse(m_ray.origin, m_ray.direction), m_nearest,
                          [this](std::uint32_t place) { test(m_data.drawables[place]); });
        return m_hit;
    }

private:
    // The direction keeps its length under the inverse matrix, so that distances are those in the world.
    void test(const PickDrawable& drawable) {
        const PickPrimitive& primitive = m_data.primitives[drawable.shared];
        const int material = primitive.materialIn(m_variant);
        const bool backs = m_materials.empty() ? m_data.doubleSided[static_cast<std::size_t>(material)]
                                               : m_materials[static_cast<std::size_t>(material)].doubleSided;
        const glm::dvec3 origin = drawable.inverse * (m_ray.origin - glm::dvec3(drawable.world[3]));
        const glm::dvec3 direction = drawable.inverse * m_ray.direction;
        const RayShear shear(origin, direction);
        primitive.tree.visit(RayInverse(origin, direction), m_nearest, [&](std::uint32_t triangle) {
            const auto crossing = shear.cross(primitive.corners[triangle]);
            if (!crossing || crossing->distance < 0 || crossing->distance > m_nearest ||
                (!backs && crossing->front == drawable.insideOut))
                return;
            m_nearest = crossing->distance;
            m_hit = Hit{.instance = drawable.instance,
                        .primitive = drawable.primitive,
                        .material = material,
                        .triangle = static_cast<int>(primitive.tree.order()[triangle]),
                        .barycentric = crossing->barycentric,
                        .point = m_ray.origin + m_nearest * m_ray.direction,
                        .distance = m_nearest};
        });
    }

    const Data& m_data;
    const Ray& m_ray;
    int m_variant;
    std::span<const Material> m_materials;
    double m_nearest;
    std::optional<Hit> m_hit;
};

Result<std::optional<Hit>> PickTree::pick(const Ray& given, const PickOptions& options) const {
    const Result<Ray> ray = normalized(given);
    if (!ray)
        return ray.error();
    if (options.variant != kNone && !isIndex(options.variant, m_data->counts.variants))
        return Error{"pick.options", "variant", "the scene has no such variant", "pass another index"};
    if (!options.materials.empty() && options.materials.size() != m_data->counts.materials)
        return Error{"pick.options", "materials", "there must be as many as the scene has",
                     "pass all of the scene's materials, or none"};
    return Search(*m_data, *ray, options.variant, options.materials).run();
}

const PickTree::Counts& PickTree::counts() const { return m_data->counts; }

Result<std::optional<Hit>> pick(const Scene& scene, const Ray& ray, const PickOptions& options) {
    return PickTree::of(scene).and_then([&](PickTree tree) { return tree.pick(ray, options); });
}

} // namespace franken
