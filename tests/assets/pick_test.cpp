// SPDX-License-Identifier: MIT
// What a ray meets, against testing every triangle, and against numbers that are worked out by hand.
#include "franken/pick.h"
#include "support/brute_pick.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <limits>
#include <random>

namespace franken::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The same numbers with every standard library.
class Random {
public:
    explicit Random(unsigned seed) : m_bits(seed) {}
    double operator()(double least, double most) {
        return least + (most - least) * static_cast<double>(m_bits()) / 4294967295.0;
    }
    glm::dvec3 vector(double size) {
        return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
    }

private:
    std::mt19937 m_bits;
};

PickTree treeOf(const Scene& scene) {
    const Result<PickTree> tree = PickTree::of(scene);
    EXPECT_TRUE(tree) << toString(tree.error());
    return *tree;
}

std::optional<Hit> hitOf(const PickTree& tree, const Ray& ray, const PickOptions& options = {}) {
    const Result<std::optional<Hit>> hit = tree.pick(ray, options);
    EXPECT_TRUE(hit) << toString(hit.error());
    return hit ? *hit : std::nullopt;
}

/// Triangles of all sizes and directions, some of them without area.
Primitive soup(Random& random, int triangles) {
    Primitive primitive;
    for (int i = 0; i < triangles; ++i) {
        const glm::dvec3 place = random.vector(2);
        const double size = i % 7 == 0 ? 1.5 : 0.2;
        for (int corner = 0; corner < 3; ++corner)
            primitive.positions.emplace_back(place + (i % 11 == 0 ? glm::dvec3(0) : random.vector(size)));
    }
    primitive.normals.assign(primitive.positions.size(), {0, 0, 1});
    for (std::size_t i = 0; i < primitive.positions.size(); ++i)
        primitive.indices.push_back(static_cast<std::uint32_t>(i));
    return primitive;
}

glm::dmat4 anyPlace(Random& random) {
    glm::dmat4 world(1.0);
    for (int axis = 0; axis < 3; ++axis)
        world[axis] = glm::dvec4(random.vector(1), 0);
    world[3] = glm::dvec4(random.vector(4), 1);
    return world;
}

Scene randomScene(Random& random, int instances) {
    SceneBuilder builder;
    Material plain, open;
    open.doubleSided = true;
    builder.addMaterial(plain);
    builder.addMaterial(open);
    Primitive ball = sphere(8), scattered = soup(random, 150), picture = square();
    scattered.material = 1;
    builder.scene.meshes = {
        {"ball", {ball, scattered}}, {"picture", {picture}}, {"soup", {soup(random, 90)}}};
    for (int i = 0; i < instances; ++i) {
        const glm::dmat4 world = anyPlace(random);
        builder.scene.instances.push_back({.name = std::to_string(i),
                                           .mesh = i % 3,
                                           .world = world,
                                           .mirrored = glm::determinant(glm::dmat3(world)) < 0});
    }
    return builder.scene;
}

void expectSame(const std::optional<Hit>& hit, const std::optional<Hit>& expected, const Scene& scene) {
    ASSERT_EQ(hit.has_value(), expected.has_value());
    if (!hit)
        return;
    EXPECT_NEAR(hit->distance, expected->distance, 1e-9);
    EXPECT_LT(glm::distance(hit->point, expected->point), 1e-9);
    EXPECT_EQ(hit->instance, expected->instance);
    EXPECT_EQ(hit->primitive, expected->primitive);
    EXPECT_EQ(hit->material, expected->material);
    EXPECT_EQ(hit->triangle, expected->triangle);
    EXPECT_LT(glm::distance(hit->barycentric, expected->barycentric), 1e-6);
    // The shares make the point out of the corners.
    const Instance& instance = scene.instances[static_cast<std::size_t>(hit->instance)];
    const Primitive& primitive = scene.meshes[static_cast<std::size_t>(instance.mesh)]
                                     .primitives[static_cast<std::size_t>(hit->primitive)];
    glm::dvec3 point(0);
    for (int corner = 0; corner < 3; ++corner)
        point +=
            hit->barycentric[corner] *
            glm::dvec3(
                primitive.positions[primitive.indices[static_cast<std::size_t>(3 * hit->triangle + corner)]]);
    EXPECT_LT(glm::distance(glm::dvec3(instance.world * glm::dvec4(point, 1)), hit->point), 1e-8);
}

TEST(Pick, IsWhatTestingAllTrianglesFinds) {
    int hits = 0, misses = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const Scene scene = randomScene(random, static_cast<int>(seed) * 2 + 1);
        const PickTree tree = treeOf(scene);
        for (int i = 0; i < 100; ++i) {
            Ray ray{random.vector(7), random.vector(1), i % 5 == 0 ? random(1, 6) : kInfinity};
            if (i % 4 == 0) // Along an axis, where boxes are grazed.
                ray.direction = {0, i % 8 == 0 ? 1 : -1, 0};
            else if (i % 4 == 1) // At something.
                ray.direction =
                    glm::dvec3(
                        scene.instances[static_cast<std::size_t>(i) % scene.instances.size()].world[3]) -
                    ray.origin + random.vector(0.5);
            ray.direction = glm::normalize(ray.direction);
            const std::optional<Hit> expected = pickByTestingAll(scene, ray);
            ++(expected ? hits : misses);
            SCOPED_TRACE("seed " + std::to_string(seed) + ", ray " + std::to_string(i));
            expectSame(hitOf(tree, ray), expected, scene);
        }
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(misses, 200);
}

Scene oneSquare(bool doubleSided = false, const glm::mat4& world = glm::mat4(1)) {
    SceneBuilder builder;
    Material material;
    material.doubleSided = doubleSided;
    builder.add(square(), builder.addMaterial(material), world);
    return builder.scene;
}

TEST(Pick, SaysWhereASquareIsHit) {
    const PickTree tree = treeOf(oneSquare());
    EXPECT_EQ(tree.counts(),
              (PickTree::Counts{.triangles = 2, .instances = 1, .materials = 1, .variants = 0}));
    const std::optional<Hit> hit = hitOf(tree, {.origin = {0.5, -0.5, 3}, .direction = {0, 0, -20}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->instance, 0);
    EXPECT_EQ(hit->primitive, 0);
    EXPECT_EQ(hit->material, 0);
    EXPECT_EQ(hit->triangle, 0); // (-1,-1), (1,-1), (1,1)
    EXPECT_NEAR(hit->distance, 3, 1e-12) << "whatever the direction's length";
    EXPECT_LT(glm::distance(hit->point, {0.5, -0.5, 0}), 1e-12);
    EXPECT_LT(glm::distance(hit->barycentric, {0.25, 0.5, 0.25}), 1e-12);
    EXPECT_EQ(hitOf(tree, {.origin = {-0.5, 0.5, 3}})->triangle, 1);
    EXPECT_FALSE(hitOf(tree, {.origin = {1.001, 0, 3}}));
    EXPECT_FALSE(hitOf(tree, {.origin = {0, 0, -3}})) << "a ray goes forward";
    EXPECT_FALSE(hitOf(tree, {.origin = {0, 0, 3}, .direction = {1, 0, 0}}));
}

TEST(Pick, EndsWithTheRay) {
    const PickTree tree = treeOf(oneSquare());
    EXPECT_TRUE(hitOf(tree, {.origin = {0, 0, 3}, .direction = {0, 0, -0.1}, .length = 3.001}));
    EXPECT_FALSE(hitOf(tree, {.origin = {0, 0, 3}, .direction = {0, 0, -0.1}, .length = 2.999}));
}

TEST(Pick, MeetsBackFacesOfDoubleSidedMaterialsAlone) {
    const Ray fromBehind{.origin = {0, 0, -3}, .direction = {0, 0, 1}}, fromAhead{.origin = {0, 0, 3}};
    const glm::mat4 mirror = glm::scale(glm::mat4(1), {-1, 1, 1});
    for (const glm::mat4& world : {glm::mat4(1), mirror}) {
        EXPECT_TRUE(hitOf(treeOf(oneSquare(false, world)), fromAhead));
        EXPECT_FALSE(hitOf(treeOf(oneSquare(false, world)), fromBehind));
        EXPECT_TRUE(hitOf(treeOf(oneSquare(true, world)), fromBehind));
    }
    const PickTree tree = treeOf(oneSquare(false));
    Material open;
    open.doubleSided = true;
    EXPECT_TRUE(hitOf(tree, fromBehind, {.materials = {&open, 1}})) << "as an application has changed it";
}

TEST(Pick, GoesByTheVariantsMaterials) {
    Scene scene = oneSquare();
    scene.variants = {"open", "same"};
    scene.materials.emplace_back().doubleSided = true;
    scene.meshes[0].primitives[0].variantMaterials = {1, kNone};
    const PickTree tree = treeOf(scene);
    const Ray fromBehind{.origin = {0, 0, -3}, .direction = {0, 0, 1}};
    EXPECT_FALSE(hitOf(tree, fromBehind));
    EXPECT_FALSE(hitOf(tree, fromBehind, {.variant = 1}));
    const std::optional<Hit> hit = hitOf(tree, fromBehind, {.variant = 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->material, 1);
    EXPECT_EQ(tree.pick(fromBehind, {.variant = 2}).error().code, "pick.options");
    EXPECT_EQ(tree.pick(fromBehind, {.materials = {scene.materials.data(), 1}}).error().where, "materials");
}

// On the edges and corners that triangles share, from everywhere: nothing shines through.
TEST(Pick, LeavesNoGapBetweenTriangles) {
    SceneBuilder builder;
    builder.add(sphere(12), builder.addMaterial({}),
                glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0.3f, 1, 0.2f)));
    const Scene& scene = builder.scene;
    const PickTree tree = treeOf(scene);
    const Primitive& ball = scene.meshes[0].primitives[0];
    const glm::dvec3 eye(0.1, 0.2, 5);
    int aimed = 0;
    for (std::size_t i = 0; i < ball.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const glm::dvec3 a(ball.positions[ball.indices[i]]), b(ball.positions[ball.indices[next]]);
        for (const double share : {0.0, 0.25, 0.5}) {
            const glm::dvec3 point(scene.instances[0].world * glm::dvec4(glm::mix(a, b, share), 1));
            if (glm::dot(point, glm::normalize(eye - point)) < 0.2)
                continue; // At the back, or near the outline.
            ++aimed;
            const std::optional<Hit> hit = hitOf(tree, {.origin = eye, .direction = point - eye});
            ASSERT_TRUE(hit) << i << ", " << share;
            EXPECT_LT(glm::distance(hit->point, point), 1e-6) << "the two ends of a round are a float apart";
        }
    }
    EXPECT_GT(aimed, 1000);
}

TEST(Pick, IsExactAtTheOtherEndOfAGlobe) {
    const glm::dvec3 place(6'371'000.25, -4'000'000.5, 1'000'000.125);
    Scene scene = oneSquare();
    scene.instances[0].world = glm::translate(glm::dmat4(1), place);
    const std::optional<Hit> hit = hitOf(treeOf(scene), {.origin = place + glm::dvec3(0.5, -0.5, 2)});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 2, 1e-9);
    EXPECT_LT(glm::distance(hit->barycentric, {0.25, 0.5, 0.25}), 1e-9);
}

TEST(Pick, TakesAnyLengthOfADirection) {
    const PickTree tree = treeOf(oneSquare());
    for (const double size : {1e-310, 1e-200, 1.0, 1e200, 1e308}) {
        const std::optional<Hit> hit = hitOf(tree, {.origin = {0.1, 0.2, 3}, .direction = {0, 0, -size}});
        ASSERT_TRUE(hit) << size;
        EXPECT_NEAR(hit->distance, 3, 1e-12) << size;
    }
}

TEST(Pick, MeetsTheEdgeOfABoxAlongEitherZero) {
    const PickTree tree = treeOf(oneSquare());
    for (const double zero : {0.0, -0.0})
        for (const glm::dvec3& origin : {glm::dvec3(-1, 0, 3), glm::dvec3(0, -1, 3)})
            EXPECT_TRUE(hitOf(tree, {.origin = origin, .direction = {zero, zero, -1}})) << zero;
}

TEST(Pick, GoesByWhatAnInstanceSaysOfItself) {
    Scene scene = oneSquare();
    scene.instances[0].mirrored = true;
    EXPECT_FALSE(hitOf(treeOf(scene), {.origin = {0, 0, 3}}));
    EXPECT_TRUE(hitOf(treeOf(scene), {.origin = {0, 0, -3}, .direction = {0, 0, 1}}));
    scene.instances[0].visible = false;
    EXPECT_FALSE(hitOf(treeOf(scene), {.origin = {0, 0, -3}, .direction = {0, 0, 1}}));
}

TEST(Pick, FindsNothingWhereThereIsNothing) {
    EXPECT_FALSE(hitOf(treeOf({}), {.origin = {0, 0, 3}}));
    EXPECT_EQ(treeOf({}).counts(), PickTree::Counts());
    Scene flat = oneSquare(true);
    flat.instances[0].world[0] = glm::dvec4(0);
    EXPECT_FALSE(hitOf(treeOf(flat), {.origin = {0, 0, 3}}));
}

struct BadRay {
    Ray ray;
    const char* where;
};

TEST(Pick, SaysWhatIsWrongWithARay) {
    const PickTree tree = treeOf(oneSquare());
    for (const auto& [ray, where] : {BadRay{{.origin = {kNaN, 0, 0}}, "origin"},
                                     {{.origin = {0, 0, kInfinity}}, "origin"},
                                     {{.direction = {0, 0, 0}}, "direction"},
                                     {{.direction = {0, kNaN, 1}}, "direction"},
                                     {{.direction = {-kInfinity, 0, 0}}, "direction"},
                                     {{.length = 0}, "length"},
                                     {{.length = -1}, "length"},
                                     {{.length = kNaN}, "length"}}) {
        const Result<std::optional<Hit>> hit = tree.pick(ray);
        ASSERT_FALSE(hit) << where;
        EXPECT_EQ(hit.error().code, "pick.ray");
        EXPECT_EQ(hit.error().where, where);
    }
}

TEST(Pick, RefusesASceneThatIsNotSound) {
    Scene scene = oneSquare();
    scene.meshes[0].primitives[0].indices[0] = 4;
    EXPECT_EQ(PickTree::of(scene).error().code, "scene.data");
    EXPECT_EQ(pick(scene, {.origin = {0, 0, 3}}).error().code, "scene.data");
    const Result<std::optional<Hit>> hit = pick(oneSquare(), {.origin = {0.5, -0.5, 3}});
    ASSERT_TRUE(hit && *hit);
    EXPECT_EQ((*hit)->triangle, 0);
}

} // namespace
} // namespace franken::test
