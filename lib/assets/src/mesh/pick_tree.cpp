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
    std::shared_ptr<const Deformation> deformation;
    std::vector<std::uint32_t> indices; ///< Of what deforms.

    int materialIn(int variant) const {
        const auto place = static_cast<std::size_t>(variant + 1);
        return place < materials.size() && materials[place] != kNone ? materials[place] : materials.front();
    }
};

/// A primitive of an instance.
struct PickDrawable {
    int instance, primitive;
    std::size_t shared; ///< Index into PickTree::Data::primitives.
    glm::dmat4 world = glm::dmat4(1.0);
    glm::dmat3 inverse = glm::dmat3(1.0); ///< Of the world's upper left part.
    bool insideOut = false; ///< What winds counter-clockwise in the world is not what counts as front.

    /// False where its matrix presses it flat.
    bool place(const Instance& from) {
        const glm::dmat3 linear(from.world);
        const double determinant = glm::determinant(linear);
        world = from.world;
        inverse = glm::inverse(linear);
        insideOut = from.mirrored != (determinant < 0);
        return determinant != 0;
    }
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
    PickPrimitive prepared{BoxTree(boxes), {}, {primitive.material}, primitive.deformation, {}};
    if (primitive.deformation)
        prepared.indices = primitive.indices;
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
    std::vector<PickDrawable> posable;     ///< All, hidden and flat ones too, in the order of instances.
    Scene outline;                         ///< Instances and skins alone.
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
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        for (std::size_t p = 0; p < scene.meshes[mesh].primitives.size(); ++p)
            drawables.push_back({.instance = static_cast<int>(i),
                                 .primitive = static_cast<int>(p),
                                 .shared = first[mesh] + p});
    }
    return drawables;
}

/// Those that are met where the scene has them.
std::vector<PickDrawable> metAtRest(const Scene& scene, std::vector<PickDrawable> drawables) {
    std::erase_if(drawables, [&](PickDrawable& drawable) {
        const Instance& instance = scene.instances[static_cast<std::size_t>(drawable.instance)];
        return !instance.visible || !drawable.place(instance);
    });
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
    data->posable = drawablesOf(scene);
    data->outline.instances = scene.instances;
    data->outline.skins = scene.skins;
    const std::vector<PickDrawable> drawables = metAtRest(scene, data->posable);
    std::vector<Box> boxes(drawables.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i].add(data->primitives[drawables[i].shared].tree.bounds(), drawables[i].world);
    data->tree = BoxTree(boxes);
    for (const std::uint32_t drawable : data->tree.order())
        data->drawables.push_back(drawables[drawable]);
    for (const Material& material : scene.materials)
        data->doubleSided.push_back(material.doubleSided);
    data->counts = {0, scene.instances.size(), scene.materials.size(), scene.variants.size(),
                    scene.nodes.size()};
    for (const PickPrimitive& primitive : data->primitives)
        data->counts.triangles += primitive.corners.size();
    return PickTree(std::move(data));
}

/// The way of one ray through the trees.
class PickTree::Search {
public:
    Search(const Data& data, const Ray& ray, const PickOptions& options)
        : m_data(data),
          m_ray(ray),
          m_variant(options.variant),
          m_materials(options.materials),
          m_nearest(ray.length) {}

    std::optional<Hit> run(const PickOptions& options) {
        if (options.pose == nullptr)
            testAtRest();
        else
            for (const PickDrawable& drawable : m_data.posable)
                testPosed(drawable, *options.pose, *options.nodes);
        return m_hit;
    }

private:
    void testAtRest() {
        m_data.tree.visit(RayInverse(m_ray.origin, m_ray.direction), m_nearest,
                          [this](std::uint32_t place) { test(m_data.drawables[place]); });
    }

    void testPosed(PickDrawable drawable, const Pose& pose, const std::vector<NodeWorld>& nodes) {
        Instance moved; // Without a name, which would be allocated.
        const Instance& instance = m_data.outline.instances[static_cast<std::size_t>(drawable.instance)];
        moved.nodeIndex = instance.nodeIndex;
        moved.skin = instance.skin;
        moved.offset = instance.offset;
        if (instance.nodeIndex == kNone) {
            moved.world = instance.world;
            moved.mirrored = instance.mirrored;
            moved.visible = instance.visible;
        }
        follow(m_data.outline, nodes, moved);
        if (!moved.visible || !drawable.place(moved))
            return;
        const PickPrimitive& primitive = m_data.primitives[drawable.shared];
        if (primitive.deformation && moved.nodeIndex != kNone)
            testDeformed(drawable, primitive, moved, pose, nodes);
        else
            test(drawable);
    }

    void testDeformed(const PickDrawable& drawable, const PickPrimitive& primitive, const Instance& instance,
                      const Pose& pose, const std::vector<NodeWorld>& nodes) {
        Palette palette;
        if (instance.skin != kNone)
            paletteOf(m_data.outline.skins[static_cast<std::size_t>(instance.skin)], nodes, palette);
        const Deforming deforming{.weights = pose.nodes[static_cast<std::size_t>(instance.nodeIndex)].weights,
                                  .joints = palette.joints};
        const Local local(drawable, m_ray);
        const Box bounds = boundsOf(*primitive.deformation, deforming);
        if (RayInverse(local.origin, local.direction).entry(bounds, m_nearest) > m_nearest)
            return;
        Vertices moved;
        deform(*primitive.deformation, deforming, moved);
        const RayShear shear(local.origin, local.direction);
        for (std::size_t triangle = 0; 3 * triangle < primitive.indices.size(); ++triangle) {
            const std::uint32_t* const index = primitive.indices.data() + 3 * triangle;
            consider(shear, {moved.positions[index[0]], moved.positions[index[1]], moved.positions[index[2]]},
                     drawable, static_cast<int>(triangle));
        }
    }

    /// The ray as it is where a drawable's vertices are. The direction keeps its length under the inverse
    /// matrix, so that distances are those in the world.
    struct Local {
        Local(const PickDrawable& drawable, const Ray& ray)
            : origin(drawable.inverse * (ray.origin - glm::dvec3(drawable.world[3]))),
              direction(drawable.inverse * ray.direction) {}
        glm::dvec3 origin, direction;
    };

    void test(const PickDrawable& drawable) {
        const PickPrimitive& primitive = m_data.primitives[drawable.shared];
        const Local local(drawable, m_ray);
        const RayShear shear(local.origin, local.direction);
        primitive.tree.visit(RayInverse(local.origin, local.direction), m_nearest,
                             [&](std::uint32_t triangle) {
                                 consider(shear, primitive.corners[triangle], drawable,
                                          static_cast<int>(primitive.tree.order()[triangle]));
                             });
    }

    void consider(const RayShear& shear, const Corners& corners, const PickDrawable& drawable, int triangle) {
        const auto crossing = shear.cross(corners);
        if (!crossing || crossing->distance < 0 || crossing->distance > m_nearest)
            return;
        const int material = m_data.primitives[drawable.shared].materialIn(m_variant);
        const bool backs = m_materials.empty() ? m_data.doubleSided[static_cast<std::size_t>(material)]
                                               : m_materials[static_cast<std::size_t>(material)].doubleSided;
        if (!backs && crossing->front == drawable.insideOut)
            return;
        m_nearest = crossing->distance;
        m_hit = Hit{.instance = drawable.instance,
                    .primitive = drawable.primitive,
                    .material = material,
                    .triangle = triangle,
                    .barycentric = crossing->barycentric,
                    .point = m_ray.origin + m_nearest * m_ray.direction,
                    .distance = m_nearest};
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
    if ((options.pose == nullptr) != (options.nodes == nullptr) ||
        (options.pose != nullptr && (options.pose->nodes.size() != m_data->counts.nodes ||
                                     options.nodes->size() != m_data->counts.nodes)))
        return Error{"pick.options", "pose", "it is not one of the scene's, with the worlds of its nodes",
                     "pass a pose of the scene, and what worldsOf() says of it"};
    return Search(*m_data, *ray, options).run(options);
}

const PickTree::Counts& PickTree::counts() const { return m_data->counts; }

Result<std::optional<Hit>> pick(const Scene& scene, const Ray& ray, const PickOptions& options) {
    return PickTree::of(scene).and_then([&](PickTree tree) { return tree.pick(ray, options); });
}

} // namespace franken
