// SPDX-License-Identifier: MIT
#include "flower.h"

#include <array>
#include <cmath>

#include "lathe.h"
#include "numbers.h"
#include "plant.h"

namespace make_model {
namespace {

/// The day's course. `hour` is its share, 0 and 1 at midnight.
namespace day {

constexpr double kSeconds = 8.0;
constexpr int kSteps = 20;

double awake(double hour) { return ramp(0.10, 0.29, hour) * (1.0 - ramp(0.74, 0.93, hour)); }

// Where the sun stands: -1 in the morning, at the left, and 1 in the evening. By night it goes back.
double sunAt(double hour) {
    constexpr double kMorning = 0.2, kEvening = 0.8;
    if (hour >= kMorning && hour <= kEvening)
        return -cosTurns(0.5 * (hour - kMorning) / (kEvening - kMorning));
    const double night = (hour < kMorning ? hour + 1.0 : hour) - kEvening;
    return 1.0 - 2.0 * ramp(0.0, 1.0 - kEvening + kMorning, night);
}

double sway(double hour, double lag) { return sinTurns(2.0 * hour + lag); }

} // namespace day

// About an axis of unit length.
glm::dvec4 turning(glm::dvec3 axis, double turns) {
    return {sinTurns(turns / 2.0) * axis, cosTurns(turns / 2.0)};
}

// The second one first.
glm::dvec4 times(const glm::dvec4& a, const glm::dvec4& b) {
    const glm::dvec3 p(a), q(b);
    return {a.w * q + b.w * p + glm::cross(p, q), a.w * b.w - glm::dot(p, q)};
}

constexpr glm::dvec3 kX(1.0, 0.0, 0.0), kY(0.0, 1.0, 0.0), kZ(0.0, 0.0, 1.0);

// The stem leans to the sun and sinks by night; the head turns after the sun and hangs by night.
glm::dvec4 rotationOf(int joint, double hour) {
    const double asleep = 1.0 - day::awake(hour), sun = day::sunAt(hour);
    if (joint < kStemJoints) {
        const double lean = -0.0085 * sun + 0.003 * day::sway(hour, 0.1 * joint);
        return times(turning(kZ, lean), turning(kX, 0.009 * asleep));
    }
    if (joint == kNeckJoint)
        return times(turning(kY, 0.085 * sun), turning(kX, 0.06 * asleep));
    if (joint == kHeadJoint)
        return times(turning(kY, 0.055 * sun), turning(kX, 0.085 * asleep));
    const int leaf = (joint - kFirstLeafJoint) / 2;
    const bool isTip = (joint - kFirstLeafJoint) % 2 == 1;
    const double droop = (isTip ? 0.045 : 0.05) * asleep + 0.008 * day::sway(hour, 0.27 * leaf);
    return turning(acrossLeaf(leaf), droop);
}

glm::dvec4 rotationOfTheSun(double hour) {
    const double sun = day::sunAt(hour);
    return aim(0.13 * sun - 0.02, -0.055 - 0.065 * (1.0 - sun * sun));
}

// Open, half closed and closed lie on the way of a petal: it is between two of them.
std::array<double, 2> weightsOf(double hour) {
    const double closed = 1.0 - day::awake(hour);
    return closed < 0.5 ? std::array{2.0 * closed, 0.0} : std::array{2.0 - 2.0 * closed, 2.0 * closed - 1.0};
}

template<typename Function>
Channel channelOf(int node, const char* path, Function values) {
    Channel channel{.node = node, .path = path};
    for (int step = 0; step <= day::kSteps; ++step)
        for (const double value : values(static_cast<double>(step % day::kSteps) / day::kSteps))
            channel.values.push_back(static_cast<float>(value));
    return channel;
}

std::array<double, 4> numbersOf(const glm::dvec4& rotation) {
    return {rotation.x, rotation.y, rotation.z, rotation.w};
}

/// The joints become nodes 0 to 15, and skin 0.
void addSkeleton(Model& model, const std::vector<PlantJoint>& joints) {
    Skin skin{.name = "plant"};
    for (const PlantJoint& joint : joints) {
        const glm::dvec3 parent =
            joint.parent < 0 ? glm::dvec3(0.0) : joints[static_cast<std::size_t>(joint.parent)].position;
        const glm::dvec3 position(snap(joint.position));
        const int node =
            add(model.nodes, {.name = joint.name, .translation = position - glm::dvec3(snap(parent))});
        if (joint.parent >= 0)
            model.nodes[static_cast<std::size_t>(joint.parent)].children.push_back(node);
        skin.joints.push_back(node);
        glm::mat4 inverse(1.0f);
        inverse[3] = glm::vec4(-snap(joint.position), 1.0f);
        skin.inverseBinds.push_back(inverse);
    }
    model.skins.push_back(std::move(skin));
}

int addSkinned(Model& model, std::string name, Mesh mesh, Material material) {
    material.name = name;
    material.metallic = 0.0;
    mesh.name = name;
    mesh.material = add(model.materials, std::move(material));
    const int index = add(model.meshes, std::move(mesh));
    return add(model.nodes, {.name = std::move(name), .mesh = index, .skin = 0});
}

int addPot(Model& model) {
    const Profile pot({
        {{{{{0.165, -0.030}, {0.175, -0.010}, {0.190, 0.000}, {0.200, -0.005}}}}, 3, {}},
        {{{{{0.200, -0.005}, {0.212, -0.010}, {0.212, -0.070}, {0.200, -0.078}}}}, 4, {}},
        {{{{{0.200, -0.078}, {0.186, -0.082}, {0.182, -0.090}, {0.180, -0.100}}}}, 2, {}},
        {{{{{0.180, -0.100}, {0.170, -0.170}, {0.158, -0.240}, {0.140, -0.310}}}}, 3, {}},
        {{{{{0.140, -0.310}, {0.139, -0.318}, {0.134, -0.322}, {0.128, -0.322}}}}, 2, {}},
    });
    const Profile soil({{{{{{0.000, 0.012}, {0.070, 0.008}, {0.130, -0.018}, {0.178, -0.026}}}}, 4, {}}});
    const int clay =
        add(model.materials,
            {.name = "clay", .baseColour = {0.42, 0.13, 0.05}, .metallic = 0.0, .roughness = 0.8});
    const int earth =
        add(model.materials, {.name = "soil", .baseColour = {0.045, 0.026, 0.014}, .metallic = 0.0});
    std::vector<int> nodes;
    struct Part {
        const char* name;
        const Profile& profile;
        int material;
    };
    for (const auto& [name, profile, material] : {Part{"pot", pot, clay}, {"soil", soil, earth}}) {
        Mesh mesh = turn(profile, {.sectors = 1, .segments = 16});
        mesh.name = name;
        mesh.material = material;
        mesh.uvs.clear();
        mesh.tangents.clear();
        nodes.push_back(add(model.nodes, {.name = name, .mesh = add(model.meshes, std::move(mesh))}));
    }
    model.nodes[static_cast<std::size_t>(nodes[0])].children = {nodes[1]};
    return nodes[0];
}

int addCamera(Model& model) {
    const int camera = add(model.cameras, {.verticalFov = 0.40, .near = 0.5, .far = 50.0});
    return add(
        model.nodes,
        {.name = "camera", .translation = {0.0, 0.84, 4.9}, .rotation = aim(0.0, -0.010), .camera = camera});
}

int addSun(Model& model) {
    const int light = add(model.lights, {"sun", {1.0, 0.95, 0.86}, 3.4});
    return add(model.nodes, {.name = "sun", .rotation = rotationOfTheSun(0.5), .light = light});
}

Animation dayOf(const Model& model, int blossom, int sun) {
    Animation animation{.name = "day"};
    for (int step = 0; step <= day::kSteps; ++step)
        animation.times.push_back(static_cast<float>(day::kSeconds * step / day::kSteps));
    for (const int joint : model.skins[0].joints)
        animation.channels.push_back(channelOf(
            joint, "rotation", [joint](double hour) { return numbersOf(rotationOf(joint, hour)); }));
    animation.channels.push_back(channelOf(blossom, "weights", weightsOf));
    animation.channels.push_back(
        channelOf(sun, "rotation", [](double hour) { return numbersOf(rotationOfTheSun(hour)); }));
    return animation;
}

} // namespace

Model makeFlower() {
    Model model;
    addSkeleton(model, plantJoints());
    const int greens = addSkinned(model, "greens", growGreens(), {.roughness = 0.6, .doubleSided = true});
    const int seeds = addSkinned(model, "seeds", growSeeds(), {.roughness = 0.85});
    const int blossom = addSkinned(model, "blossom", growBlossom(), {.roughness = 0.55, .doubleSided = true});
    const int pot = addPot(model);
    const int camera = addCamera(model);
    const int sun = addSun(model);
    model.animations.push_back(dayOf(model, blossom, sun));
    add(model.nodes, {.name = "scene", .children = {0, greens, seeds, blossom, pot, camera, sun}});
    return model;
}

} // namespace make_model
