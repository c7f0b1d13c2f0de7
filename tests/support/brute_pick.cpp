// SPDX-License-Identifier: MIT
#include "support/brute_pick.h"

#include <glm/geometric.hpp>

namespace franken::test {
namespace {

struct Crossing {
    double distance, v, w;
    bool front;
};

std::optional<Crossing> cross(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 left = b - a, right = c - a, across = glm::cross(ray.direction, right);
    const double determinant = glm::dot(left, across);
    if (determinant == 0)
        return std::nullopt;
    const glm::dvec3 from = ray.origin - a, other = glm::cross(from, left);
    const double v = glm::dot(from, across) / determinant;
    const double w = glm::dot(ray.direction, other) / determinant;
    const double distance = glm::dot(right, other) / determinant;
    if (v < 0 || w < 0 || v + w > 1 || distance < 0 || distance > ray.length)
        return std::nullopt;
    return Crossing{distance, v, w, determinant > 0};
}

} // namespace

std::optional<Hit> pickByTestingAll(const Scene& scene, const Ray& ray) {
    std::optional<Hit> nearest;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const auto& primitives = scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives;
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const bool backs = scene.materials[static_cast<std::size_t>(primitives[p].material)].doubleSided;
            const auto corner = [&](std::size_t index) {
                return glm::dvec3(instance.world *
                                  glm::dvec4(primitives[p].positions[primitives[p].indices[index]], 1));
            };
            for (std::size_t t = 0; t < primitives[p].indices.size() / 3; ++t) {
                const auto crossing = cross(ray, corner(3 * t), corner(3 * t + 1), corner(3 * t + 2));
                if (!crossing || (nearest && crossing->distance >= nearest->distance) ||
                    (!backs && crossing->front == instance.mirrored))
                    continue;
                const auto [distance, v, w, front] = *crossing;
                nearest = Hit{static_cast<int>(i),
                              static_cast<int>(p),
                              primitives[p].material,
                              static_cast<int>(t),
                              {1 - v - w, v, w},
                              ray.origin + distance * ray.direction,
                              distance};
            }
        }
    }
    return nearest;
}

} // namespace franken::test
