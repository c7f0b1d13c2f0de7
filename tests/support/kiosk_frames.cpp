// SPDX-License-Identifier: MIT
#include "support/kiosk_frames.h"

#include "support/shapes.h"
#include "support/snake.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>

namespace franken::test {
namespace {

constexpr std::array kLooks = {Look{}, Look{.toneMap = ToneMap::Aces}};

// Every alpha mode, wraps of all kinds, factors and textures, vertex colours.
Scene tiledBall() {
    SceneBuilder builder;
    Material material = tiledMaterial(builder);
    material.doubleSided = true;
    builder.add(sphere(8), builder.addMaterial(material));
    return builder.scene;
}

Scene leafAndGlass() {
    SceneBuilder builder;
    Material leaf;
    leaf.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(8, 4, {0.2f, 0.8f, 0.3f, 1}, {0, 0, 0, 0}), Filter::Nearest);
    leaf.alphaMode = AlphaMode::Mask;
    builder.add(square(), builder.addMaterial(leaf));
    Material glass;
    glass.factors.baseColor = {0.5f, 0.6f, 1, 0.4f};
    glass.factors.roughness = 0.1f;
    glass.factors.metallic = 0;
    glass.alphaMode = AlphaMode::Blend;
    builder.add(sphere(8), builder.addMaterial(glass));
    return builder.scene;
}

Scene paintedSign() {
    SceneBuilder builder;
    Material sign;
    sign.unlit = true;
    Primitive board = square();
    board.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    builder.add(board, builder.addMaterial(sign));
    Material lamp;
    lamp.factors.emissive = {2, 1, 0.5f};
    builder.add(sphere(6), builder.addMaterial(lamp));
    return builder.scene;
}

// What moves: skins of a morph in parts by programs, and by the CPU, which has those of more than four
// joints.
constexpr std::array kSnakes = {Snake{.influences = 4, .joints = 40, .target = true, .rings = 6},
                                Snake{.influences = 5, .joints = 9, .rings = 6}};

std::vector<Lighting> lightsOnAndOff() {
    const Sun sun{.direction = {-1, -1, -1}, .illuminance = 3};
    const PunctualLight point{.position = {0, 1, 2}, .intensity = 2};
    PunctualLight spot = point;
    spot.spot = true;
    Lighting dark, day, dusk, night, sky;
    dark.ambient = {.kind = Ambient::Color, .color = {0.2f, 0.2f, 0.2f}};
    day = dark;
    day.suns = {sun, sun};
    dusk = dark;
    dusk.suns = {sun};
    dusk.punctualLights = {point};
    night.punctualLights = {spot, spot, point};
    sky.ambient.kind = Ambient::Sky;
    sky.reflection = Reflection::Lookup;
    sky.ambient.sky[0] = {1, 1, 1};
    sky.suns = {sun};
    return {dark, day, dusk, night, sky};
}

} // namespace

KioskFrames::KioskFrames()
    : m_scenes{tiledBall(), leafAndGlass(), paintedSign(), sceneOf(kSnakes[0]), sceneOf(kSnakes[1])},
      m_lightings(lightsOnAndOff()),
      m_sky{.size = 1, .range = 64, .images = {}} {
    m_sky.images.fill({"", 1, 1, {255, 255, 255, 64}});
}

std::vector<ProgramUse> KioskFrames::uses() const {
    std::vector<ProgramUse> all;
    for (const Look& look : kLooks) {
        for (const Scene& scene : m_scenes)
            for (const Lighting& lighting : m_lightings) {
                const Result<std::vector<ProgramUse>> uses = usesOf(scene, lighting, look);
                all.insert(all.end(), uses->begin(), uses->end());
            }
        all.push_back(*skyboxUse(look));
    }
    return all;
}

Result<void> KioskFrames::load(Renderer& renderer) {
    for (const Scene& scene : m_scenes) {
        const Result<ModelId> model = renderer.add(scene);
        if (!model)
            return model.error();
        const Result<PlaceId> place = renderer.addPlace(*model);
        if (!place)
            return place.error();
        m_models.push_back(*model);
        m_places.push_back(*place);
    }
    return {};
}

// A second place that moves, is mirrored, comes and goes, and a material's factors.
Result<void> KioskFrames::change(Renderer& renderer, int frame, std::size_t model) {
    const glm::dvec3 mirror(frame % 10 < 5 ? 1 : -1, 1, 1);
    const glm::dmat4 world = glm::rotate(glm::scale(glm::dmat4(1), mirror), 0.1 * frame, glm::dvec3(0, 1, 0));
    if (Result<void> moved = renderer.setWorld(m_places[model], world); !moved)
        return moved;
    if (const std::size_t snake = model + kSnakes.size() - m_scenes.size(); snake < kSnakes.size())
        for (const PlaceId place : {*renderer.firstPlace(m_models[model]), m_places[model]}) {
            const double amount = std::sin(0.1 * frame + (place == m_places[model] ? 1 : 0));
            if (Result<void> posed = renderer.setPose(place, bent(m_scenes[model], kSnakes[snake], amount));
                !posed)
                return posed;
        }
    if (Result<void> hidden = renderer.setVisible(m_places[model], frame % 3 != 0); !hidden)
        return hidden;
    Result<Material> material = renderer.materialOf(m_models[model], 0);
    if (!material)
        return material.error();
    material->factors.roughness = 0.2f + 0.01f * static_cast<float>(frame % 70);
    return renderer.setMaterial(m_models[model], 0, *material);
}

Result<void> KioskFrames::draw(Renderer& renderer, int frame, const std::vector<DrawTarget>& targets) {
    const auto turn = [frame](std::size_t period, std::size_t count) {
        return static_cast<std::size_t>(frame) / period % count;
    };
    const std::size_t model = turn(7, m_models.size());
    if (frame % 7 == 0)
        if (Result<void> shown = renderer.show({{m_models[model]}}, Wait::Yes); !shown)
            return shown;
    if (frame % 11 == 0)
        if (Result<void> changed = renderer.setSkybox(turn(11, 2) == 0 ? nullptr : &m_sky); !changed)
            return changed;
    renderer.setLook(kLooks[turn(50, kLooks.size())]);
    Lighting lighting = m_lightings[turn(3, m_lightings.size())];
    lighting.skyRotation = glm::angleAxis(0.01 * frame, glm::dvec3(0, 1, 0));
    renderer.setLighting(lighting);
    const DrawTarget& target = targets[turn(25, targets.size())];
    const Camera camera = framingCamera(m_scenes[model].bounds(), 1);
    if (Result<void> changed = change(renderer, frame, model); !changed)
        return changed;
    return renderer.draw(viewpointOf(camera, aspectOf(target)), target);
}

} // namespace franken::test
