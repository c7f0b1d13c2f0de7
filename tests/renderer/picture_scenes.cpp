// SPDX-License-Identifier: MIT
#include "picture_scenes.h"

#include "franken/displacement.h"
#include "picture_shots.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace franken::test {
namespace {

int addChecks(SceneBuilder& builder) { return builder.addTexture(checkers(64, 8, kOrange, kBlue)); }

int addPacked(SceneBuilder& builder) {
    return builder.addTexture(paint(64, [](glm::vec2 uv) {
        return glm::vec4(0.3f + 0.7f * std::abs(2 * uv.x - 1), 0.1f + 0.9f * uv.y, uv.x < 0.5f ? 0 : 1, 1);
    }));
}

Shot textured() {
    return dressedBall([](SceneBuilder& builder, Material& material) {
        material.textures[TextureRole::BaseColor].texture = addChecks(builder);
    });
}

Shot bumpy() {
    return dressedBall([](SceneBuilder& builder, Material& material) {
        material.factors.baseColor = toFloat4(kOrange);
        material.textures[TextureRole::Normal].texture = builder.addTexture(bumps(128, 8));
        material.factors.normalScale = 1.5f;
    });
}

Shot packed() {
    Shot shot = dressedBall([](SceneBuilder& builder, Material& material) {
        material.factors.baseColor = toFloat4(kOrange);
        material.factors.metallic = 1;
        material.factors.roughness = 1;
        material.textures[TextureRole::MetallicRoughness].texture = addPacked(builder);
        material.textures[TextureRole::Occlusion].texture =
            material.textures[TextureRole::MetallicRoughness].texture;
        material.factors.occlusionStrength = 0.8f;
    });
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.3f, 0.3f, 0.35f}};
    return shot;
}

Shot occluded() {
    Shot shot = dressedBall([](SceneBuilder& builder, Material& material) {
        material.textures[TextureRole::Occlusion].texture = addPacked(builder);
    });
    shot.lighting.suns.clear();
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.5f, 0.6f, 0.7f}};
    return shot;
}

Shot glowing() {
    Shot shot = dressedBall([](SceneBuilder& builder, Material& material) {
        material.factors.baseColor = {0.1f, 0.1f, 0.1f, 1};
        material.factors.emissive = {3, 2, 1};
        material.textures[TextureRole::Emissive].texture = addChecks(builder);
    });
    shot.look.toneMap = ToneMap::Reinhard;
    shot.lighting.exposure = 0.7f;
    return shot;
}

Shot masked() {
    return dressedBall([](SceneBuilder& builder, Material& material) {
        material.textures[TextureRole::BaseColor].texture =
            builder.addTexture(checkers(64, 8, kOrange, glm::vec4(kBlue.r, kBlue.g, kBlue.b, 0)));
        material.alphaMode = AlphaMode::Mask;
        material.doubleSided = true;
    });
}

// Given front to back: only sorting draws them right.
Shot blended() {
    SceneBuilder builder;
    const glm::vec4 colors[] = {{0.9f, 0.1f, 0.1f, 0.5f}, {0.1f, 0.9f, 0.1f, 0.5f}, {0.1f, 0.1f, 0.9f, 0.5f}};
    for (int i = 0; i < 3; ++i) {
        Material material = plain(0, 1);
        material.factors.baseColor = toFloat4(colors[i]);
        material.alphaMode = AlphaMode::Blend;
        const glm::vec3 place(0.4f * static_cast<float>(i - 1), 0.3f * static_cast<float>(1 - i),
                              -0.3f * static_cast<float>(i));
        builder.add(square(), builder.addMaterial(material),
                    glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(0.6f)));
    }
    builder.add(sphere(kRings), builder.addMaterial(plain(0, 0.4f)),
                glm::scale(glm::translate(glm::mat4(1), {0, 0, -1}), glm::vec3(0.7f)));
    return shotOfScene(std::move(builder));
}

/// Two squares, seen from the front and from behind.
Shot sided(bool doubleSided) {
    SceneBuilder builder;
    Material material = plain(0, 0.5f);
    material.doubleSided = doubleSided;
    const int index = builder.addMaterial(material);
    for (const auto& [x, turn] : {std::pair(-0.6f, 0.2f), std::pair(0.6f, -2.2f)})
        builder.add(square(), index,
                    glm::scale(glm::rotate(glm::translate(glm::mat4(1), {x, 0, 0}), turn, glm::vec3(0, 1, 0)),
                               glm::vec3(0.6f)));
    return shotOfScene(std::move(builder));
}

Shot tinted() {
    SceneBuilder builder;
    Primitive primitive = sphere(kRings);
    for (const glm::vec3& normal : primitive.normals)
        primitive.colors.emplace_back(0.5f + 0.5f * normal, 1);
    Material material = plain(0, 0.6f);
    material.factors.baseColor = toFloat4(kWhite);
    builder.add(std::move(primitive), builder.addMaterial(material));
    return shotOfScene(std::move(builder));
}

glm::mat3 turnedAndTripled() {
    const float c = 3 * std::cos(0.5f), s = 3 * std::sin(0.5f);
    return {c, -s, 0, s, c, 0, 0.1f, 0.2f, 1};
}

Shot twoStreams() {
    SceneBuilder builder;
    Material material = plain(0, 0.5f);
    material.factors.baseColor = toFloat4(kWhite);
    material.textures[TextureRole::BaseColor] = {
        .texture = addChecks(builder), .transform = turnedAndTripled(), .transformed = true};
    material.textures[TextureRole::Normal] = {.texture = builder.addTexture(bumps(64, 4)), .uvSet = 1};
    Primitive primitive = square();
    primitive.uv[1] = primitive.uv[0];
    builder.add(std::move(primitive), builder.addMaterial(material));
    return shotOfScene(std::move(builder));
}

Shot unlit() {
    Shot shot = textured();
    shot.scene.materials[0].unlit = true;
    return shot;
}

Shot withBrdf(Brdf brdf) {
    Shot shot = ball(plain(1, 0.6f));
    shot.look.brdf = brdf;
    return shot;
}

/// A ball that is bright enough to show what a tone map does.
Shot toneMapped(ToneMap toneMap) {
    Shot shot = ball(plain(0.5f, 0.4f));
    shot.lighting.exposure = 3;
    shot.look.toneMap = toneMap;
    return shot;
}

Shot withOutput(Output output, Dither dither) {
    Shot shot = ball(plain(0, 0.5f));
    shot.look.output = output;
    shot.look.dither = dither;
    return shot;
}

Shot withDecode(Decode decode) {
    Shot shot = textured();
    shot.look.decode = decode;
    return shot;
}

Shot withView(View view) {
    Shot shot = packed();
    SceneBuilder builder{.scene = shot.scene};
    builder.scene.materials[0].textures[TextureRole::Normal].texture = builder.addTexture(bumps(128, 8));
    builder.scene.materials[0].textures[TextureRole::BaseColor].texture = addChecks(builder);
    shot.scene = builder.scene;
    shot.look.view = view;
    return shot;
}

Shot stretchedAndMirrored() {
    SceneBuilder builder;
    const int material = builder.addMaterial(plain(0, 0.3f));
    const glm::mat4 left = glm::translate(glm::mat4(1), {-0.8f, 0, 0});
    const glm::mat4 right = glm::translate(glm::mat4(1), {0.8f, 0, 0});
    builder.add(sphere(kRings), material, glm::scale(left, glm::vec3(0.4f, 0.9f, 0.4f)));
    builder.add(sphere(kRings), material, glm::scale(right, glm::vec3(-0.7f, 0.5f, 0.7f)));
    return shotOfScene(std::move(builder));
}

Shot orthographic() {
    Shot shot = textured();
    shot.camera.projection = Camera::Projection::Orthographic;
    shot.camera.xmag = 2;
    shot.camera.ymag = 1.5f;
    shot.camera.zfar = 10;
    return shot;
}

Shot perVertex() {
    Shot shot = bumpy();
    shot.look.lightVectors = LightVectors::PerVertex;
    return shot;
}

Shot wrapsAndFilters() {
    SceneBuilder builder;
    int column = 0;
    for (const Wrap wrap : {Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat}) {
        for (const Filter filter : {Filter::Nearest, Filter::Linear}) {
            const int texture = builder.addTexture(
                paint(4, [](glm::vec2 uv) { return glm::vec4(uv.x, uv.y, 0.2f, 1); }), filter, wrap);
            builder.scene.textures.back().magFilter = filter;
            Material material;
            material.unlit = true;
            material.textures[TextureRole::BaseColor] = {
                .texture = texture, .transform = glm::mat3(3, 0, 0, 0, 3, 0, -1, -1, 1), .transformed = true};
            const glm::vec3 place(-0.9f + 0.9f * static_cast<float>(column / 2),
                                  column % 2 == 0 ? 0.5f : -0.5f, 0);
            builder.add(square(), builder.addMaterial(material),
                        glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(0.4f)));
            ++column;
        }
    }
    return shotOfScene(std::move(builder));
}

Shot background() {
    Shot shot = ball(plain(0, 1));
    shot.background = {0.2f, 0.3f, 0.4f};
    return shot;
}

Shot displaced() {
    Shot shot = bumpy();
    const auto waves = [](glm::vec2 uv) { return glm::vec4(0.5f - 0.5f * std::cos(31.415927f * uv.x)); };
    EXPECT_TRUE(displace(shot.scene, {.image = paint(64, waves), .scale = 0.3f, .ground = 1}));
    return shot;
}

} // namespace

std::vector<PictureRow> pictureRows() {
    std::vector<PictureRow> rows = {
        {"dielectric", [] { return ball(plain(0, 0.3f)); }},
        {"metal", [] { return ball(plain(1, 0.3f)); }},
        {"metal_energy",
         [] {
             Shot shot = ball(plain(1, 0.8f));
             shot.look.energy = true;
             return shot;
         }},
        {"base_color_texture", textured},
        {"normal_map", bumpy},
        {"packed_textures", packed},
        {"occlusion", occluded},
        {"emissive_reinhard", glowing},
        {"mask", masked},
        {"blend", blended},
        {"single_sided", [] { return sided(false); }},
        {"double_sided", [] { return sided(true); }},
        {"vertex_colors", tinted},
        {"two_uv_streams", twoStreams},
        {"unlit", unlit},
        {"brdf_seed", [] { return withBrdf(Brdf::Seed); }},
        {"brdf_fast", [] { return withBrdf(Brdf::Fast); }},
        {"brdf_schlick", [] { return withBrdf(Brdf::Schlick); }},
        {"tone_none", [] { return toneMapped(ToneMap::None); }},
        {"tone_aces", [] { return toneMapped(ToneMap::Aces); }},
        {"tone_neutral", [] { return toneMapped(ToneMap::Neutral); }},
        {"output_pow22", [] { return withOutput(Output::Pow22, Dither::None); }},
        {"output_linear", [] { return withOutput(Output::Linear, Dither::None); }},
        {"output_fast_dithered", [] { return withOutput(Output::SrgbFast, Dither::Ordered); }},
        {"decode_fast", [] { return withDecode(Decode::Fast); }},
        {"decode_none", [] { return withDecode(Decode::None); }},
        {"view_base_color", [] { return withView(View::BaseColor); }},
        {"view_normal", [] { return withView(View::Normal); }},
        {"view_metalrough", [] { return withView(View::RoughnessMetallic); }},
        {"view_occlusion", [] { return withView(View::Occlusion); }},
        {"stretched_and_mirrored", stretchedAndMirrored},
        {"orthographic", orthographic},
        {"vertex_light", perVertex},
        {"wraps_and_filters", wrapsAndFilters},
        {"background", background},
        {"height_map", displaced},
    };
    for (const PictureRow& row : lightRows())
        rows.push_back(row);
    return rows;
}

} // namespace franken::test
