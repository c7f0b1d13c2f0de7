// SPDX-License-Identifier: MIT
#include "frame_counts.h"

#include "draw_counter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <tuple>

using namespace franken;

namespace price {
namespace {

/// A primitive of an instance, and what its place among the others follows from.
struct Object {
    const Instance* instance;
    const Primitive* primitive;
    MaterialPlan plan;
    bool isMasked = false, isBlended = false, samples = false;
    std::size_t program = 0; ///< Programs are numbered as they come.
    double depth = 0;
    int slice = 0;
};

glm::dvec3 centreOf(const Object& object) {
    const Box& box = object.primitive->bounds;
    return glm::dvec3(object.instance->world * glm::dvec4(0.5 * (box.min + box.max), 1));
}

/// Its box, as the renderer asks: what is not drawn is not sorted either.
bool isBeside(const FrameContents& frame, const Instance& instance, const Box& box) {
    const glm::dmat4 toClip = frame.viewpoint.viewProjection * instance.world;
    std::array<glm::dvec4, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] =
            toClip * glm::dvec4((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                                (i & 4U) != 0 ? box.max.z : box.min.z, 1);
    return isBesideTheView(corners);
}

Result<std::vector<Object>> objectsOf(const FrameContents& frame) {
    std::vector<Object> objects;
    std::vector<Permutation> programs;
    for (const Instance& instance : frame.scene.instances) {
        if (!instance.visible)
            continue;
        for (const Primitive& primitive :
             frame.scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
            if (isBeside(frame, instance, primitive.bounds))
                continue;
            Object object{&instance, &primitive, {}};
            object.plan = planMaterial(frame.scene, primitive.material, contentsOf(primitive));
            const Result<Permutation> program = permutationOf(object.plan, frame.lighting, frame.look);
            if (!program)
                return program.error();
            const auto found = std::find(programs.begin(), programs.end(), *program);
            object.program = static_cast<std::size_t>(found - programs.begin());
            if (found == programs.end())
                programs.push_back(*program);
            object.isMasked = object.plan.permutation.alpha == Alpha::Mask;
            object.isBlended = object.plan.permutation.alpha == Alpha::Blend;
            object.samples = std::any_of(textureRoles().begin(), textureRoles().end(),
                                         [&](const TextureRoleRow& role) { return role.there(*program); });
            object.depth = glm::dot(centreOf(object) - frame.viewpoint.eye, frame.viewpoint.forward);
            objects.push_back(object);
        }
    }
    return objects;
}

// As DrawList::sortFrontToBack(), which says why.
void assignSlices(std::vector<Object*>& objects) {
    constexpr double kSlices = 16;
    if (objects.empty())
        return;
    const auto byDepth = [](const Object* a, const Object* b) { return a->depth < b->depth; };
    const auto [nearest, farthest] = std::minmax_element(objects.begin(), objects.end(), byDepth);
    const double least = (*nearest)->depth, most = (*farthest)->depth;
    const double thinnest = 1e-4 * std::max(std::abs(least), std::abs(most));
    const double scale = most - least > thinnest ? (kSlices - 1) / (most - least) : 0;
    for (Object* object : objects)
        object->slice = static_cast<int>((object->depth - least) * scale + 0.5);
}

std::vector<Object*> frontToBack(std::vector<Object>& objects) {
    std::vector<Object*> order;
    for (Object& object : objects)
        if (!object.isBlended)
            order.push_back(&object);
    assignSlices(order);
    std::stable_sort(order.begin(), order.end(), [](const Object* a, const Object* b) {
        const auto key = [](const Object& object) {
            return std::tuple(object.isMasked, object.samples, object.program, object.slice,
                              object.primitive->material, object.instance->mesh);
        };
        return key(*a) < key(*b);
    });
    return order;
}

std::vector<Object*> backToFront(std::vector<Object>& objects) {
    std::vector<Object*> order;
    for (Object& object : objects)
        if (object.isBlended)
            order.push_back(&object);
    std::stable_sort(order.begin(), order.end(),
                     [](const Object* a, const Object* b) { return a->depth > b->depth; });
    return order;
}

} // namespace

Result<FrameCounts> countFrame(const FrameContents& frame) {
    Result<std::vector<Object>> objects = objectsOf(frame);
    if (!objects)
        return objects.error();
    DrawCounter counter(frame);
    for (const Object* object : frontToBack(*objects)) {
        const bool isDoubleSided = object->plan.permutation.sides == Sides::Double;
        counter.add(*object->instance, *object->primitive, object->plan,
                    isDoubleSided ? Faces::Both : Faces::Front);
    }
    counter.addSkybox();
    for (const Object* object : backToFront(*objects)) {
        if (object->plan.permutation.sides == Sides::Double)
            counter.add(*object->instance, *object->primitive, object->plan, Faces::Back);
        counter.add(*object->instance, *object->primitive, object->plan, Faces::Front);
    }
    return counter.take();
}

std::vector<Shaded> shadedOf(const FrameCounts& counts, EarlyDepth early) {
    std::vector<Shaded> shaded;
    bool tests = true;
    for (const Draw& draw : counts.draws) {
        tests = tests && !(early == EarlyDepth::UntilDiscard && draw.isMasked);
        shaded.push_back(tests ? draw.shaded : draw.covered);
    }
    return shaded;
}

Result<Permutation> programOf(const Draw& draw, const Lighting& lighting, const Look& look) {
    return draw.isSkybox ? skyPermutation(look) : permutationOf(draw.plan, lighting, look);
}

} // namespace price
