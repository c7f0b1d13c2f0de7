// SPDX-License-Identifier: MIT
#include "model.h"

#include <utility>

#include "canvas.h"
#include "lathe.h"
#include "mounts.h"
#include "numbers.h"
#include "plinth.h"
#include "urn.h"

namespace make_model {
namespace {

int addPorcelain(Model& model) {
    const Canvas canvas(urnProfile(), kUrnTurning.sectors, 512, paintUrn);
    const int packed =
        add(model.images, {"porcelain_occlusion_roughness_metallic", canvas.occlusionRoughnessMetallic()});
    return add(model.materials,
               {.name = "porcelain",
                .emissive = glm::dvec3(1.0),
                .baseColourImage = add(model.images, {"porcelain_base_colour", canvas.baseColour()}),
                .metallicRoughnessImage = packed,
                .normalImage = add(model.images, {"porcelain_normal", canvas.normals()}),
                .occlusionImage = packed,
                .emissiveImage = add(model.images, {"porcelain_emissive", canvas.emissive()})});
}

int addStone(Model& model) {
    const Canvas canvas(plinthProfile(), kPlinthTurning.sectors, 256, paintPlinth);
    return add(model.materials,
               {.name = "stone",
                .metallic = 0.0,
                .roughness = 0.55,
                .baseColourImage = add(model.images, {"stone_base_colour", canvas.baseColour()}),
                .normalImage = add(model.images, {"stone_normal", canvas.normals()}),
                .occlusionImage = add(model.images, {"stone_occlusion", canvas.occlusion()})});
}

int addMesh(Model& model, std::string name, Mesh mesh, int material) {
    mesh.name = std::move(name);
    mesh.material = material;
    return add(model.meshes, std::move(mesh));
}

int addUrn(Model& model) {
    const int gilt =
        add(model.materials, {.name = "gilt", .baseColour = {1.0, 0.66, 0.24}, .roughness = 0.40});
    const int porcelain = addMesh(model, "porcelain", turn(urnProfile(), kUrnTurning), addPorcelain(model));
    const int mounts = addMesh(model, "mounts", turnMounts(), gilt);
    const int handle = addMesh(model, "handle", bendHandle(), gilt);

    // Broader than thick: the bar is round in the mesh.
    const glm::dvec3 strap(1.0, 1.0, 1.5);
    const int right = add(model.nodes, {.name = "right handle", .scale = strap, .mesh = handle});
    const int left =
        add(model.nodes, {.name = "left handle", .rotation = aim(0.5, 0.0), .scale = strap, .mesh = handle});
    const int metal = add(model.nodes, {.name = "mounts", .children = {right, left}, .mesh = mounts});
    return add(model.nodes, {.name = "urn",
                             .translation = {0.0, 0.345, 0.0},
                             .rotation = aim(-0.038, 0.0),
                             .children = {metal},
                             .mesh = porcelain});
}

int addPlinth(Model& model) {
    const int plinth = addMesh(model, "plinth", turn(plinthProfile(), kPlinthTurning), addStone(model));
    return add(model.nodes, {.name = "plinth", .translation = {0.0, 0.345, 0.0}, .mesh = plinth});
}

int addSun(Model& model, DirectionalLight light, glm::dvec4 rotation) {
    const std::string name = light.name;
    const int index = add(model.lights, std::move(light));
    return add(model.nodes, {.name = name, .rotation = rotation, .light = index});
}

int addCamera(Model& model) {
    const int camera = add(model.cameras, {.verticalFov = 0.45, .near = 0.5, .far = 50.0});
    return add(
        model.nodes,
        {.name = "camera", .translation = {0.0, 1.83, 5.1}, .rotation = aim(0.0, -0.027), .camera = camera});
}

} // namespace

glm::dvec4 aim(double turned, double tilted) {
    const double sinTurn = sinTurns(turned / 2.0);
    const double cosTurn = cosTurns(turned / 2.0);
    const double sinTilt = sinTurns(tilted / 2.0);
    const double cosTilt = cosTurns(tilted / 2.0);
    const glm::dvec4 exact(cosTurn * sinTilt, sinTurn * cosTilt, -sinTurn * sinTilt, cosTurn * cosTilt);
    return glm::floor(exact * 1e6 + 0.5) / 1e6;
}

Model makeModel() {
    Model model;
    const int urn = addUrn(model);
    const int plinth = addPlinth(model);
    const int camera = addCamera(model);
    const int key = addSun(model, {"warm key", {1.0, 0.91, 0.78}, 3.6}, aim(-0.09, -0.075));
    const int rim = addSun(model, {"cool rim", {0.55, 0.75, 1.0}, 3.0}, aim(0.27, -0.02));
    add(model.nodes, {.name = "scene", .children = {plinth, urn, camera, key, rim}});
    return model;
}

} // namespace make_model
