// SPDX-License-Identifier: MIT
// Invalid arguments of a caller: each ends in an error with a code, and the renderer goes on.
#include "misuse_stage.h"

#include <functional>
#include <limits>

namespace franken::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

template<typename Value>
Result<void> outcome(const Result<Value>& result) {
    return result ? Result<void>() : Result<void>(result.error());
}

struct Misuse {
    const char* name;
    const char* code;
    std::function<Result<void>(Stage&)> act;
};

void PrintTo(const Misuse& misuse, std::ostream* out) { *out << misuse.name; }

/// Adds a scene after a change.
std::function<Result<void>(Stage&)> addChanged(std::function<void(Scene&)> change) {
    return [change](Stage& stage) {
        Scene scene = ball();
        change(scene);
        return outcome(stage.renderer.add(scene));
    };
}

/// Draws after a change of the only sun, or of a spot light.
std::function<Result<void>(Stage&)> drawLit(std::function<void(Lighting&)> change) {
    return [change](Stage& stage) {
        Lighting lighting = sunny(1, 1);
        lighting.punctualLights[0].spot = true;
        change(lighting);
        return stage.lit(lighting);
    };
}

std::function<Result<void>(Stage&)> drawTo(std::function<void(DrawTarget&)> change) {
    return [change](Stage& stage) {
        DrawTarget target = kTarget;
        change(target);
        return stage.draw({}, target);
    };
}

std::function<Result<void>(Stage&)> drawFrom(std::function<void(Viewpoint&)> change) {
    return [change](Stage& stage) {
        Viewpoint viewpoint;
        change(viewpoint);
        return stage.draw(viewpoint);
    };
}

Primitive& first(Scene& scene) { return scene.meshes[0].primitives[0]; }

const std::vector<Misuse> kScenes = {
    {"NoNormals", "scene.data", addChanged([](Scene& s) { first(s).normals.clear(); })},
    {"FewNormals", "scene.data", addChanged([](Scene& s) { first(s).normals.pop_back(); })},
    {"NormalsOfNoLength", "scene.data", addChanged([](Scene& s) { first(s).normals[3] = glm::vec3(0); })},
    {"NormalNotANumber", "scene.data", addChanged([](Scene& s) { first(s).normals[3].y = kNan; })},
    {"FewTangents", "scene.data", addChanged([](Scene& s) { first(s).tangents.resize(1); })},
    {"ManyColors", "scene.data", addChanged([](Scene& s) { first(s).colors.resize(100'000); })},
    {"FewTextureCoordinates", "scene.data", addChanged([](Scene& s) { first(s).uv[0].pop_back(); })},
    {"InfinitePosition", "scene.data", addChanged([](Scene& s) { first(s).positions[0].x = kInfinity; })},
    {"NoPositions", "scene.data", addChanged([](Scene& s) { first(s).positions.clear(); })},
    {"IndexOfNoVertex", "scene.data", addChanged([](Scene& s) { first(s).indices[5] = 1u << 30; })},
    {"HalfATriangle", "scene.data", addChanged([](Scene& s) { first(s).indices.pop_back(); })},
    {"NoMaterial", "scene.data", addChanged([](Scene& s) { s.materials.clear(); })},
    {"MaterialOutOfRange", "scene.data", addChanged([](Scene& s) { first(s).material = 7; })},
    {"MaterialBelowZero", "scene.data", addChanged([](Scene& s) { first(s).material = -1; })},
    {"MeshOutOfRange", "scene.data", addChanged([](Scene& s) { s.instances[0].mesh = 1; })},
    {"MeshBelowZero", "scene.data", addChanged([](Scene& s) { s.instances[0].mesh = -5; })},
    {"PlaceNotANumber", "scene.data", addChanged([](Scene& s) { s.instances[0].world[3][1] = kNan; })},
    {"TextureOutOfRange", "scene.data",
     addChanged([](Scene& s) { s.materials[0].textures[TextureRole::BaseColor].texture = 99; })},
    {"TextureBelowNone", "scene.data",
     addChanged([](Scene& s) { s.materials[0].textures[TextureRole::Normal].texture = -2; })},
    {"ThirdTextureCoordinates", "scene.data",
     addChanged([](Scene& s) { s.materials[0].textures[TextureRole::BaseColor].uvSet = 2; })},
    {"TransformNotANumber", "scene.data",
     addChanged([](Scene& s) { s.materials[0].textures[TextureRole::BaseColor].transform[0][0] = kNan; })},
    {"TextureWithoutImage", "scene.data", addChanged([](Scene& s) { s.textures[0].image = kNone; })},
    {"ImageOutOfRange", "scene.data", addChanged([](Scene& s) { s.textures[0].image = 50; })},
    {"WrapOfNoKind", "scene.data", addChanged([](Scene& s) { s.textures[0].wrapS = Wrap(9); })},
    {"FilterOfNoKind", "scene.data", addChanged([](Scene& s) { s.textures[0].minFilter = Filter(-1); })},
    {"EmptyImage", "scene.data", addChanged([](Scene& s) { s.images[0] = {}; })},
    {"HugeImageWithoutBytes", "scene.data",
     addChanged([](Scene& s) { s.images[0].width = s.images[0].height = 100'000; })},
    {"ImageOfNegativeSize", "scene.data", addChanged([](Scene& s) { s.images[0].width = -64; })},
    {"FactorNotANumber", "scene.data", addChanged([](Scene& s) { s.materials[0].factors.roughness = kNan; })},
    {"NegativeEmission", "scene.data", addChanged([](Scene& s) { s.materials[0].factors.emissive[1] = -1; })},
    {"MetalnessInTwoTextures", "scene.data", addChanged([](Scene& s) {
         MaterialTextures& textures = s.materials[0].textures;
         textures[TextureRole::MetallicRoughness] = textures[TextureRole::Metallic] =
             textures[TextureRole::BaseColor];
     })},
    {"RoughnessAtOtherCoordinates", "scene.data", addChanged([](Scene& s) {
         MaterialTextures& textures = s.materials[0].textures;
         textures[TextureRole::Metallic] = textures[TextureRole::Roughness] =
             textures[TextureRole::BaseColor];
         textures[TextureRole::Roughness].uvSet = 1;
     })},
    {"AlphaModeOfNoKind", "scene.data",
     addChanged([](Scene& s) { s.materials[0].alphaMode = AlphaMode(7); })},
};

const std::vector<Misuse> kFrames = {
    {"SunNotANumber", "renderer.lighting", drawLit([](Lighting& l) { l.suns[0].illuminance = kNan; })},
    {"SunOfNoDirection", "renderer.lighting", drawLit([](Lighting& l) { l.suns[0].direction = {}; })},
    {"SunOfInfiniteColor", "renderer.lighting", drawLit([](Lighting& l) { l.suns[0].color[2] = kInfinity; })},
    {"LightNowhere", "renderer.lighting",
     drawLit([](Lighting& l) { l.punctualLights[0].position[0] = kNan; })},
    {"SpotOfNoDirection", "renderer.lighting",
     drawLit([](Lighting& l) { l.punctualLights[0].direction = {}; })},
    {"NegativeIntensity", "renderer.lighting",
     drawLit([](Lighting& l) { l.punctualLights[0].intensity = -1; })},
    {"NegativeRange", "renderer.lighting", drawLit([](Lighting& l) { l.punctualLights[0].range = -1; })},
    {"ConeNotANumber", "renderer.lighting",
     drawLit([](Lighting& l) { l.punctualLights[0].outerCone = kNan; })},
    {"AmbientNotANumber", "renderer.lighting", drawLit([](Lighting& l) { l.ambient.color[1] = kNan; })},
    {"SkyNotANumber", "renderer.lighting", drawLit([](Lighting& l) { l.ambient.sky[4][1] = kNan; })},
    {"InfiniteExposure", "renderer.lighting", drawLit([](Lighting& l) { l.exposure = kInfinity; })},
    {"NegativeExposure", "renderer.lighting", drawLit([](Lighting& l) { l.exposure = -1; })},
    {"AmbientOfNoKind", "permutation.range", drawLit([](Lighting& l) { l.ambient.kind = Ambient(77); })},
    {"BrdfOfNoKind", "permutation.range",
     [](Stage& stage) {
         stage.renderer.setLook({.brdf = Brdf(9)});
         return stage.draw();
     }},
    {"OverlaysOutputOfNoKind", "permutation.range",
     [](Stage& stage) {
         stage.renderer.setLook({.output = Output(200)});
         return stage.overlay(OverlayRect{0, 0, 1, 1});
     }},
    {"NoWidth", "renderer.target", drawTo([](DrawTarget& t) { t.width = 0; })},
    {"NegativeHeight", "renderer.target", drawTo([](DrawTarget& t) { t.height = -48; })},
    {"NegativeBits", "renderer.target", drawTo([](DrawTarget& t) { t.bits[1] = -3; })},
    {"ManyBits", "renderer.target", drawTo([](DrawTarget& t) { t.bits[0] = 64; })},
    {"BackgroundNotANumber", "renderer.target", drawTo([](DrawTarget& t) { t.background[0] = kNan; })},
    {"WarmUpInNothing", "renderer.target",
     [](Stage& stage) { return outcome(stage.renderer.warmUp({.width = 0, .height = 0}, {})); }},
    {"WarmUpOfNoProgram", "permutation.range",
     [](Stage& stage) {
         ProgramUse use;
         use.permutation.suns = 200;
         return outcome(stage.renderer.warmUp(kTarget, {&use, 1}));
     }},
    {"MatrixNotANumber", "renderer.viewpoint", drawFrom([](Viewpoint& v) { v.viewProjection[2][2] = kNan; })},
    {"InfiniteEye", "renderer.viewpoint", drawFrom([](Viewpoint& v) { v.eye.z = kInfinity; })},
    {"ForwardNotANumber", "renderer.viewpoint", drawFrom([](Viewpoint& v) { v.forward.x = kNan; })},
    {"SkyMatrixNotANumber", "renderer.viewpoint", drawFrom([](Viewpoint& v) { v.clipToSky[1][0] = kNan; })},
};

const std::vector<Misuse> kPictures = {
    {"EmptyPicture", "renderer.image", [](Stage& s) { return outcome(s.renderer.addPicture({})); }},
    {"PictureWithoutBytes", "renderer.image",
     [](Stage& s) {
         return outcome(s.renderer.addPicture({"", 100'000, 100'000, {}}));
     }},
    {"PictureOfFewBytes", "renderer.image",
     [](Stage& s) {
         return outcome(s.renderer.addPicture({"", 8, 8, std::vector<std::uint8_t>(255)}));
     }},
    {"QuadNotANumber", "renderer.overlay",
     [](Stage& s) {
         return s.overlay({0, kNan, 1, 1});
     }},
    {"QuadOfNoColor", "renderer.overlay",
     [](Stage& s) {
         return s.overlay({0, 0, 1, 1}, {0, 0, kNan, 1});
     }},
    {"UnknownPicture", "renderer.picture", [](Stage& s) { return s.overlay(OverlayQuad{}); }},
    {"PictureAfterRemove", "renderer.picture",
     [](Stage& stage) {
         const Result<PictureId> picture = stage.renderer.addPicture(white(2, 2));
         stage.renderer.removePicture(*picture);
         return stage.overlay(OverlayQuad{.picture = *picture, .place = {}});
     }},
    {"PictureOfAnother", "renderer.picture",
     [](Stage& stage) {
         Stage other;
         return stage.overlay(OverlayQuad{.picture = *other.renderer.addPicture(white(2, 2)), .place = {}});
     }},
    {"ModelOfAnother", "renderer.model",
     [](Stage& stage) {
         Stage other;
         const Result<ModelId> id = other.renderer.add(ball());
         return stage.renderer.show({{*id}}, Wait::Yes);
     }},
    {"ModelAfterRemove", "renderer.model",
     [](Stage& stage) {
         const Result<ModelId> id = stage.renderer.add(ball());
         stage.renderer.remove(*id);
         return stage.renderer.show({{*id}}, Wait::Yes);
     }},
    {"SkyboxWithoutFaces", "renderer.image",
     [](Stage& stage) {
         const SkyboxMap cube{.size = 16, .range = 1, .images = {}};
         return stage.renderer.setSkybox(&cube);
     }},
    {"SkyboxOfTwoSizes", "renderer.sky",
     [](Stage& stage) {
         SkyboxMap cube = whiteCube(16);
         cube.images[4] = white(8, 8);
         return stage.renderer.setSkybox(&cube);
     }},
    {"SkyboxTooLarge", "renderer.sky",
     [](Stage& stage) {
         const SkyboxMap cube = whiteCube(5000);
         return stage.renderer.setSkybox(&cube);
     }},
    {"SkyboxOfNoRange", "renderer.sky",
     [](Stage& stage) {
         SkyboxMap cube = whiteCube(16);
         cube.range = kNan;
         return stage.renderer.setSkybox(&cube);
     }},
    {"EmptyReflection", "renderer.image",
     [](Stage& stage) {
         const ReflectionMaps maps;
         return stage.renderer.setReflection(&maps);
     }},
};

class MisuseTest : public testing::TestWithParam<Misuse> {};

constexpr auto kNameOf = [](const testing::TestParamInfo<Misuse>& info) {
    return std::string(info.param.name);
};
INSTANTIATE_TEST_SUITE_P(Scenes, MisuseTest, testing::ValuesIn(kScenes), kNameOf);
INSTANTIATE_TEST_SUITE_P(Frames, MisuseTest, testing::ValuesIn(kFrames), kNameOf);
INSTANTIATE_TEST_SUITE_P(Pictures, MisuseTest, testing::ValuesIn(kPictures), kNameOf);

TEST_P(MisuseTest, IsAnErrorAndTheRendererGoesOn) {
    Stage stage;
    const Result<void> result = GetParam().act(stage);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, GetParam().code) << toString(result.error());
    EXPECT_FALSE(result.error().what.empty());
    stage.renderer.setLook({});
    EXPECT_TRUE(stage.lit(sunny()));
    EXPECT_TRUE(stage.overlay(OverlayRect{0, 0, 1, 1}));
}

} // namespace
} // namespace franken::test
