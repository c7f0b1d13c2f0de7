// SPDX-License-Identifier: MIT
#include "support/snake.h"

#include "franken/complete.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace franken::test {
namespace {

/// The influences of a vertex on its way along the chain: the joints around it, the nearest the most.
std::vector<Influence> influencesAt(double along, const Snake& snake) {
    std::vector<Influence> influences(static_cast<std::size_t>(snake.influences));
    const double nearest = std::floor(along - 0.5 * (snake.influences - 1) + 0.5);
    const int first = std::clamp(static_cast<int>(nearest), 0, snake.joints - snake.influences);
    double sum = 0;
    for (std::size_t i = 0; i < influences.size(); ++i) {
        const int joint = first + static_cast<int>(i);
        const double weight = std::exp(-0.5 * (along - joint) * (along - joint));
        influences[i] = {static_cast<std::uint32_t>(joint), static_cast<float>(weight)};
        sum += weight;
    }
    for (Influence& influence : influences)
        influence.weight = static_cast<float>(influence.weight / sum);
    return influences;
}

} // namespace

std::ostream& operator<<(std::ostream& out, const Snake& snake) {
    return out << snake.influences << " of " << snake.joints << " joints" << (snake.target ? ", morphed" : "")
               << (snake.mirrored ? ", mirrored" : "");
}

Scene sceneOf(const Snake& snake) {
    SceneBuilder builder;
    builder.addSun({-0.5f, -0.6f, -0.7f}, {1, 1, 1}, 3);
    Primitive ball = sphere(snake.rings);
    Deformation deformation{.bind = {}, .influencesPerVertex = static_cast<std::size_t>(snake.influences)};
    Vertices wider;
    for (glm::vec3& position : ball.positions) {
        position.y *= 2;
        for (const Influence& influence : influencesAt((position.y + 2.0) / 4 * (snake.joints - 1), snake))
            deformation.influences.push_back(influence);
        wider.positions.emplace_back(0.5f * position.x, 0, 0);
    }
    if (snake.target)
        deformation.targets = {wider};
    ball.deformation = std::make_shared<const Deformation>(deformation);
    Material material;
    material.factors.metallic = 0.3f;
    material.factors.roughness = 0.4f;
    material.textures[TextureRole::Normal].texture = builder.addTexture(bumps(64, 4));
    builder.add(ball, builder.addMaterial(material));
    Node mesh;
    if (snake.target)
        mesh.rest.weights = {0.25f};
    builder.scene.nodes = {mesh};
    Skin skin;
    const double step = 4.0 / (snake.joints - 1);
    for (int joint = 0; joint < snake.joints; ++joint) {
        const double y = joint == 0 ? -2 : step;
        builder.scene.nodes.push_back(
            {.parent = joint == 0 ? kNone : joint, .rest = {.local = {.translation = {0, y, 0}}}});
        skin.joints.push_back(joint + 1);
        glm::mat4 inverse(1);
        inverse[3].y = static_cast<float>(2 - step * joint);
        skin.inverseBinds.push_back(inverse);
    }
    builder.scene.skins = {skin};
    builder.scene.instances[0].nodeIndex = 0;
    builder.scene.instances[0].skin = 0;
    Result<Scene> scene = complete(builder.scene);
    EXPECT_TRUE(scene) << toString(scene.error());
    return *std::move(scene);
}

Pose bent(const Scene& scene, const Snake& snake, double amount) {
    Pose pose = restPose(scene);
    if (snake.target)
        pose.nodes[0].weights = {static_cast<float>(amount)};
    for (std::size_t node = 1; node < pose.nodes.size(); ++node) {
        const double angle = amount * 2.5 / snake.joints;
        pose.nodes[node].local.rotation =
            glm::dquat(std::cos(angle / 2), std::sin(angle / 2) * glm::dvec3(0.3, 0.2, 0.933));
        pose.nodes[node].local.scale = glm::dvec3(1, 1, 1.0 + 0.1 / snake.joints);
        if (snake.mirrored && node % 3 == 0)
            pose.nodes[node].local.scale.x = -1;
    }
    return pose;
}

} // namespace franken::test
