// SPDX-License-Identifier: MIT
// What becomes of a surface's numbers on their way to a pixel: cutoffs, alpha, texture coordinates, decoding,
// sides.
#include "numbers.h"
#include "support/brdf_reference.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace franken::test {
namespace {

using SurfaceNumbers = PictureTest;
INSTANTIATE_TEST_SUITE_P(Backends, SurfaceNumbers, allBackends(), backendName);

using Codes = std::array<int, 3>;
constexpr Codes kBlack{0, 0, 0}, kWhite{255, 255, 255};

Material white() {
    Material material;
    material.unlit = true;
    return material;
}

// glTF 2.0, 3.9.4: what is at the cutoff or above it is drawn.
TEST_P(SurfaceNumbers, AMaskKeepsWhatIsAtItsCutoff) {
    for (const float cutoff : {0.25f, 0.5f, 0.75f})
        for (const auto& [alpha, codes] :
             {std::pair(cutoff, kWhite), {cutoff - 0.002f, kBlack}, {1.0f, kWhite}}) {
            Material material = white();
            material.alphaMode = AlphaMode::Mask;
            material.factors.alphaCutoff = cutoff;
            material.factors.baseColor[3] = alpha;
            EXPECT_EQ(codesOf(draw(filledBy(material))), codes) << alpha << " at " << cutoff;
        }
}

Shot tinted(Material material, const glm::vec4& color) {
    SceneBuilder builder;
    Primitive primitive = square();
    primitive.colors.assign(4, color);
    builder.add(std::move(primitive), builder.addMaterial(material));
    return filledBy(builder);
}

TEST_P(SurfaceNumbers, AlphaOfVertexColoursCounts) {
    Material material = white();
    material.factors.baseColor[3] = 0.5f;
    material.alphaMode = AlphaMode::Blend;
    const Codes blended = codesOf(draw(tinted(material, {1, 0.5f, 0, 0.5f})));
    EXPECT_NEAR(blended[0], 0.25 * 255, 1);
    EXPECT_NEAR(blended[1], 0.125 * 255, 1);
    EXPECT_EQ(blended[2], 0);
    material.alphaMode = AlphaMode::Mask;
    material.factors.alphaCutoff = 0.3f;
    EXPECT_EQ(codesOf(draw(tinted(material, {1, 1, 1, 0.5f}))), kBlack);
    EXPECT_EQ(codesOf(draw(tinted(material, {1, 1, 1, 0.7f}))), kWhite);
}

// glTF 2.0, 3.9.3: 1 + strength (texel - 1), of ambient light. Packed or in a texture of its own, R says how
// much.
TEST_P(SurfaceNumbers, OcclusionHasItsStrength) {
    for (const float strength : {0.0f, 0.25f, 1.0f})
        for (const bool packed : {false, true}) {
            SceneBuilder builder;
            Material material;
            material.factors.metallic = 0;
            material.factors.occlusionStrength = strength;
            material.textures[TextureRole::Occlusion].texture = builder.addTexture(texel(51, 255, 0)); // 0.2
            if (packed)
                material.textures[TextureRole::MetallicRoughness] = material.textures[TextureRole::Occlusion];
            builder.add(square(), builder.addMaterial(material));
            Shot shot = filledBy(builder);
            shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.9f, 0.9f, 0.9f}};
            EXPECT_NEAR(codesOf(draw(shot))[0], 255 * 0.9 * (1 - 0.8 * strength), 1) << strength << packed;
        }
}

// A texture of both numbers, or one of each: a role whose texture is missing has its factor alone.
TEST_P(SurfaceNumbers, MetalnessAndRoughnessMayHaveATextureEach) {
    for (const std::uint8_t metal : {std::uint8_t{64}, std::uint8_t{255}})
        for (const std::uint8_t rough : {std::uint8_t{128}, std::uint8_t{255}}) {
            std::vector<Picture> pictures;
            for (const bool packed : {true, false}) {
                SceneBuilder builder;
                Material material;
                MaterialTextures& textures = material.textures;
                material.factors.roughness = 0.8f;
                if (packed)
                    textures[TextureRole::MetallicRoughness].texture =
                        builder.addTexture(texel(0, rough, metal));
                if (!packed && metal < 255)
                    textures[TextureRole::Metallic].texture = builder.addTexture(texel(metal, 0, 0));
                if (!packed && rough < 255)
                    textures[TextureRole::Roughness].texture = builder.addTexture(texel(rough, 0, 0));
                builder.add(sphere(16), builder.addMaterial(material));
                Shot shot = filledBy(builder);
                shot.lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
                pictures.push_back(draw(shot));
            }
            EXPECT_LE(compareLit(pictures[0], pictures[1]).max(), 1) << int{metal} << ", " << int{rough};
        }
}

// Through the near glass the far one is seen, whichever stands first in the file.
TEST_P(SurfaceNumbers, FarGlassesAreBehindNearOnes) {
    for (const bool nearFirst : {true, false}) {
        SceneBuilder builder;
        for (const bool isNear : {nearFirst, !nearFirst}) {
            Material material = white();
            material.alphaMode = AlphaMode::Blend;
            material.factors.baseColor = isNear ? Float4{1, 0, 0, 0.5f} : Float4{0, 1, 0, 0.5f};
            builder.add(square(), builder.addMaterial(material),
                        glm::translate(glm::mat4(1), glm::vec3(0, 0, isNear ? 0.5f : -0.5f)));
        }
        const Codes codes = codesOf(draw(filledBy(builder)));
        EXPECT_NEAR(codes[0], 0.5 * 255, 1) << nearFirst;
        EXPECT_NEAR(codes[1], 0.25 * 255, 1) << nearFirst;
    }
}

// Two things of one material: each stands where it stands.
TEST_P(SurfaceNumbers, EachThingIsWhereItStands) {
    SceneBuilder builder;
    const int material = builder.addMaterial(white());
    for (const glm::vec3 place : {glm::vec3(-0.5f, 0.5f, 0), glm::vec3(0.5f, -0.5f, 0)})
        builder.add(square(), material, glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(0.4f)));
    const Picture picture = draw(filledBy(builder));
    EXPECT_EQ(codesAt(picture, 16, 16), kWhite);
    EXPECT_EQ(codesAt(picture, 48, 48), kWhite);
    EXPECT_EQ(codesAt(picture, 48, 16), kBlack);
    EXPECT_EQ(codesAt(picture, 16, 48), kBlack);
}

TEST_P(SurfaceNumbers, WhatIsBehindAGlassIsSeenByItsAlpha) {
    SceneBuilder builder;
    Material material = white();
    material.factors.baseColor = {0, 1, 0, 0.25f};
    material.alphaMode = AlphaMode::Blend;
    material.textures[TextureRole::BaseColor].texture = builder.addTexture(texel(255, 255, 255, 204)); // 0.8
    builder.add(square(), builder.addMaterial(material));
    for (const Decode decode : {Decode::Exact, Decode::Fast, Decode::None}) {
        Shot shot = filledBy(builder);
        shot.look.decode = decode;
        shot.background = {1, 1, 1};
        const Codes codes = codesOf(draw(shot));
        EXPECT_NEAR(codes[0], 0.8 * 255, 1) << static_cast<int>(decode);
        EXPECT_NEAR(codes[1], 255, 1);
    }
}

/// u is red, v is green, in steps of 17 codes.
Image ramps() {
    return paint(16, [](glm::vec2 uv) { return glm::vec4(glm::floor(uv * 16.0f) / 15.0f, 0, 1); });
}

/// What a nearest filter finds at the middle of a pixel, whose coordinates are moved by `transform`.
Codes rampsAt(int x, int y, const glm::dmat3& transform) {
    const glm::dvec3 uv = transform * glm::dvec3((x + 0.5) / 64, (y + 0.5) / 64, 1);
    return {17 * static_cast<int>(16 * (uv.x - std::floor(uv.x))),
            17 * static_cast<int>(16 * (uv.y - std::floor(uv.y))), 0};
}

/// Turned by a quarter, scaled and moved.
glm::mat3 turned() { return {0, -0.5f, 0, 0.5f, 0, 0, 0.125f, 0.6875f, 1}; }
glm::mat3 moved() { return {1, 0, 0, 0, 1, 0, 0.25f, 0.4375f, 1}; }

/// The base colour through one transform, and what glows through the other; each by its own coordinates.
struct TwoTextures {
    glm::mat3 base, glow;
    int baseSet, glowSet;
};

Shot shotOf(const TwoTextures& textures) {
    SceneBuilder builder;
    Primitive primitive = square();
    for (const glm::vec2& uv : primitive.uv[0])
        primitive.uv[1].push_back(1.0f - uv); // The other way round, so that one is not taken for the other.
    const int ramp = builder.addTexture(ramps(), Filter::Nearest);
    builder.scene.textures[0].magFilter = Filter::Nearest;
    const auto ref = [ramp](const glm::mat3& transform, int set) {
        return TextureRef{
            .texture = ramp, .uvSet = set, .transform = transform, .transformed = transform != glm::mat3(1)};
    };
    Material material;
    material.textures[TextureRole::BaseColor] = ref(textures.base, textures.baseSet);
    material.textures[TextureRole::Emissive] = ref(textures.glow, textures.glowSet);
    material.factors.emissive = {1, 1, 1};
    builder.add(std::move(primitive), builder.addMaterial(material));
    Shot shot = filledBy(builder);
    shot.look.decode = Decode::None;
    return shot;
}

void expectRamps(const Picture& picture, int set, const glm::mat3& transform) {
    // From the set's coordinates to those of the picture.
    const glm::dmat3 flip = set == 0 ? glm::dmat3(1) : glm::dmat3(-1, 0, 0, 0, -1, 0, 1, 1, 1);
    for (const auto& [x, y] : {std::pair(5, 9), {30, 22}, {41, 50}, {62, 33}}) {
        const Codes expected = rampsAt(x, y, glm::dmat3(transform) * flip), actual = codesAt(picture, x, y);
        for (std::size_t channel = 0; channel < 2; ++channel)
            EXPECT_EQ(actual[channel], expected[channel])
                << "set " << set << ", (" << x << ", " << y << "), channel " << channel;
    }
}

TEST_P(SurfaceNumbers, EachTextureHasItsCoordinatesAndTransform) {
    const TwoTextures rows[] = {
        {glm::mat3(1), moved(), 0, 0}, {moved(), glm::mat3(1), 0, 1}, {glm::mat3(1), moved(), 0, 1},
        {glm::mat3(1), moved(), 1, 0}, {turned(), moved(), 0, 1},     {moved(), turned(), 1, 1},
        {turned(), turned(), 1, 0},
    };
    for (const TwoTextures& row : rows) {
        Shot shot = shotOf(row);
        // One alone, by its light: what glows in the dark, and what an ambient light of white shows of the
        // rest.
        expectRamps(draw(shot), row.glowSet, row.glow);
        shot.scene.materials[0].factors.emissive = {1e-6f, 1e-6f, 1e-6f};
        shot.lighting.ambient = {.kind = Ambient::Color, .color = {1, 1, 1}};
        expectRamps(draw(shot), row.baseSet, row.base);
    }
}

/// IEC 61966-2-1.
double decoded(int code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Image grey(int code) {
    const auto byte = static_cast<std::uint8_t>(code);
    return texel(byte, byte, byte);
}

TEST_P(SurfaceNumbers, GlowAndColourAreDecodedAndMultiplied) {
    for (const Decode decode : {Decode::Exact, Decode::Fast})
        for (const int code : {20, 64, 128, 188, 230, 255})
            for (const bool glows : {true, false}) {
                SceneBuilder builder;
                Material material = white();
                const int texture = builder.addTexture(grey(code));
                const glm::vec3 factor(1, 0.5f, 0.25f);
                material.unlit = !glows;
                material.factors.baseColor = glows ? Float4{0, 0, 0, 1} : toFloat4(glm::vec4(factor, 1));
                material.textures[glows ? TextureRole::Emissive : TextureRole::BaseColor].texture = texture;
                material.factors.emissive = {factor.r, factor.g, factor.b};
                builder.add(square(), builder.addMaterial(material));
                Shot shot = filledBy(builder);
                shot.look.decode = decode;
                const Codes codes = codesOf(draw(shot));
                for (int channel = 0; channel < 3;
                     ++channel) // The fast form is a cubic: off by half a percent.
                    EXPECT_NEAR(codes[static_cast<std::size_t>(channel)],
                                255 * decoded(code) * factor[channel], 1.6)
                        << code << (glows ? " glows" : "");
            }
}

// What is far away is the mean of the light that its texels send, not of their codes.
TEST_P(SurfaceNumbers, FarTexturesAreAsBrightAsNearOnes) {
    SceneBuilder builder;
    Material material = white();
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(64, 64, {0, 0, 0, 1}, glm::vec4(1)));
    Primitive primitive = square();
    for (glm::vec2& uv : primitive.uv[0])
        uv *= 16.0f; // 16 texels a pixel along each side.
    builder.add(std::move(primitive), builder.addMaterial(material));
    for (const std::array<int, 3>& codes = codesOf(draw(filledBy(builder))); const int code : codes)
        EXPECT_NEAR(code, 0.5 * 255, 3);
}

/// The square with its front or its back to the camera.
Shot sided(bool back, const Lighting& lighting) {
    SceneBuilder builder;
    Material material;
    material.factors.baseColor = {0.9f, 0.7f, 0.5f, 1};
    material.factors.metallic = 0;
    material.factors.roughness = 0.6f;
    material.doubleSided = back;
    const float turn = back ? glm::pi<float>() : 0.0f;
    builder.add(square(), builder.addMaterial(material), glm::rotate(glm::mat4(1), turn, glm::vec3(0, 1, 0)));
    Shot shot = filledBy(builder);
    shot.lighting = lighting;
    return shot;
}

Environment skyBrightAt(bool front) {
    Environment sky{.width = 16, .height = 8, .texels = {}};
    for (int i = 0; i < sky.width * sky.height; ++i) {
        const double longitude = 2 * glm::pi<double>() * (i % 16 + 0.5) / 16; // +Z is where u is 1/4 or 3/4.
        const bool bright = (std::sin(longitude) > 0) == front;
        sky.texels.push_back(bright ? glm::vec3(0.6f, 0.5f, 0.4f) : glm::vec3(0.05f));
    }
    return sky;
}

std::vector<Lighting> oneSidedLights() {
    std::vector<Lighting> all(4);
    all[0].suns = {{.direction = {0.3f, -0.2f, -1}, .illuminance = 2}};
    all[1].suns = {{.direction = {0.3f, -0.2f, 1}, .illuminance = 2}}; // Behind what is seen.
    for (const bool front : {true, false}) {
        Lighting& lighting = all[front ? 2 : 3];
        lighting.ambient = {.kind = Ambient::Sky, .sky = skyCoefficients(skyBrightAt(front))};
    }
    return all;
}

// glTF 2.0, 3.9.5: the normal of a back face is reversed, whatever tells fronts from backs.
TEST_P(SurfaceNumbers, BacksAreLitAsFrontsWhereverLightComesFrom) {
    std::set<int> levels;
    for (const Lighting& lighting : oneSidedLights()) {
        const Codes front = codesOf(draw(sided(false, lighting)));
        levels.insert(front[0]);
        for (const bool workaround : {false, true})
            for (const Target target : kForms) {
                Shot shot = withForms(sided(true, lighting), target);
                shot.look.facingWorkaround = workaround;
                EXPECT_NEAR(codesOf(draw(shot))[0], front[0], 1) << "a back, workaround " << workaround;
                shot.scene.instances[0].world = glm::dmat4(1);
                EXPECT_NEAR(codesOf(draw(shot))[0], front[0], 1) << "a front, workaround " << workaround;
            }
    }
    EXPECT_GT(*levels.rbegin(), *levels.begin() + 40) << "lights from behind and from the front differ";
}

Picture flipped(const Picture& picture) {
    Picture other = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.rgba.begin() + 4 * (y * picture.width + picture.width - 1 - x), 4,
                        other.rgba.begin() + 4 * (y * picture.width + x));
    return other;
}

// In a mirror the sun stands on the other side as well: the mirrored ball's picture is the ball's, mirrored.
TEST_P(SurfaceNumbers, MirroredAndStretchedThingsAreLitByTheirShape) {
    for (const bool doubleSided : {false, true}) {
        std::array<Picture, 2> pictures;
        for (const float side : {1.0f, -1.0f}) {
            SceneBuilder builder;
            Material material;
            material.factors.metallic = 0;
            material.factors.roughness = 0.5f;
            material.doubleSided = doubleSided;
            builder.add(sphere(24), builder.addMaterial(material),
                        glm::scale(glm::mat4(1), glm::vec3(0.5f * side, 0.9f, 0.9f)));
            Shot shot = filledBy(builder);
            shot.lighting.suns = {{.direction = {-0.8f * side, -0.3f, -0.5f}, .illuminance = 2}};
            pictures[side > 0 ? 0 : 1] = draw(shot);
        }
        const Difference difference = compareLit(flipped(pictures[1]), pictures[0]);
        EXPECT_GT(difference.pixels, 900u);
        EXPECT_TRUE(difference.mean <= 0.1 && difference.shareAbove(2) <= 0.02) << difference;
        // The normal of the ellipsoid (x / 0.5)^2 + (y / 0.9)^2 + (z / 0.9)^2 = 1 at x = 0.25, y = 0.
        const double z = 0.9 * std::sqrt(1 - 0.25);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.25 / 0.25, 0, z / 0.81));
        const LitPoint point{.normal = normal,
                             .toCamera = {0, 0, 1},
                             .toLight = glm::normalize(glm::dvec3(0.8, 0.3, 0.5)),
                             .metallic = 0,
                             .roughness = 0.5};
        const double expected = radianceOf(point, Brdf::Gltf).x * 2 / glm::pi<double>();
        EXPECT_NEAR(codesAt(pictures[0], 40, 32)[0], 255 * expected, 5);
    }
}

TEST_P(SurfaceNumbers, TheFacingWorkaroundIsAnotherProgram) {
    Shot shot = sided(true, oneSidedLights()[0]);
    const auto before = usesOf(shot.scene, shot.lighting, shot.look);
    shot.look.facingWorkaround = true;
    const auto after = usesOf(shot.scene, shot.lighting, shot.look);
    ASSERT_TRUE(before && after);
    EXPECT_NE(before->at(0).permutation, after->at(0).permutation);
    EXPECT_NE(toName(after->at(0).permutation).find("workaround-facing"), std::string::npos);
}

// The program of two suns over all textures has an order of its own on vc4.
TEST_P(SurfaceNumbers, TwoSunsOverAllTexturesLookTheSameInAllForms) {
    SceneBuilder builder;
    Material material = tiledMaterial(builder);
    material.textures[TextureRole::Occlusion] = material.textures[TextureRole::MetallicRoughness];
    material.textures[TextureRole::Emissive].texture =
        builder.addTexture(checkers(8, 2, {0.1f, 0.2f, 0.6f, 1}, {0, 0, 0, 1}));
    material.factors.emissive = {1, 0.8f, 0.6f};
    material.factors.occlusionStrength = 0.7f;
    builder.add(sphere(32), builder.addMaterial(material));
    Shot shot = filledBy(builder);
    shot.lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 2},
                          {.direction = {1, 0, -1}, .illuminance = 1}};
    shot.lighting.ambient = {.kind = Ambient::Color, .color = {0.3f, 0.2f, 0.1f}};
    shot.look.decode = Decode::Fast;
    shot.look.output = Output::SrgbFast;
    shot.look.target = Target::Vc4;
    const auto uses = usesOf(shot.scene, shot.lighting, shot.look);
    ASSERT_TRUE(uses);
    EXPECT_NE(toName(uses->at(0).permutation).find("occlusion-packed.emissive"), std::string::npos);
    const Difference difference = compareLit(draw(shot), draw(withForms(shot, Target::Generic)));
    std::cout << "two suns over all textures: " << difference << "\n";
    EXPECT_GT(difference.pixels, 2000u);
    EXPECT_LE(difference.mean, 0.01);
    EXPECT_LE(difference.max(), 1);
}

} // namespace
} // namespace franken::test
