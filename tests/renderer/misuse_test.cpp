// SPDX-License-Identifier: MIT
// What a caller can get wrong, and a driver: each ends in an error with a code, none in a signal or a loss.
#include "franken/renderer.h"
#include "support/fault_driver.h"
#include "support/null_gl.h"
#include "support/shapes.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace franken::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr DrawTarget kTarget{.width = 64, .height = 48};

Scene ball() {
    SceneBuilder builder;
    builder.add(sphere(6), builder.addMaterial(tiledMaterial(builder)));
    return builder.scene;
}

Lighting sunny(std::size_t suns = 1, std::size_t punctualLights = 0) {
    Lighting lighting;
    for (std::size_t i = 0; i < suns; ++i)
        lighting.suns.push_back(
            {.direction = {std::cos(float(i)), -1, std::sin(float(i))}, .illuminance = 1});
    for (std::size_t i = 0; i < punctualLights; ++i)
        lighting.punctualLights.push_back({.position = {double(i), 2, 0}, .intensity = float(i + 1)});
    return lighting;
}

Image white(int width, int height) {
    return {"white", width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height, 255)};
}

SkyboxMap whiteCube(int size) {
    SkyboxMap cube{.size = size, .range = 1, .images = {}};
    cube.images.fill(white(size, size));
    return cube;
}

template<typename Value>
Result<void> outcome(const Result<Value>& result) {
    return result ? Result<void>() : Result<void>(result.error());
}

/// A renderer that shows something, on a driver that does nothing.
struct Stage {
    Stage() : renderer(gl) {
        renderer.setLighting(sunny());
        EXPECT_TRUE(renderer.load(ball(), [] { return Result<Scene>(ball()); }));
        EXPECT_TRUE(draw());
    }
    Result<void> draw(const Viewpoint& viewpoint = {}, const DrawTarget& target = kTarget) {
        return renderer.draw(viewpoint, target);
    }
    Result<void> lit(const Lighting& lighting) {
        renderer.setLighting(lighting);
        return draw();
    }
    Result<void> overlay(const OverlayQuad& quad) { return renderer.drawOverlay({&quad, 1}, kTarget); }
    Result<void> overlay(OverlayRect place, Float4 color = {1, 1, 1, 1}) {
        const Result<PictureId> picture = renderer.addPicture(white(2, 2));
        return overlay(OverlayQuad{.picture = *picture, .place = place, .color = color});
    }

    Gl gl = nullGl();
    Renderer renderer;
};

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
     addChanged([](Scene& s) { s.materials[0].baseColorTexture.texture = 99; })},
    {"TextureBelowNone", "scene.data",
     addChanged([](Scene& s) { s.materials[0].normalTexture.texture = -2; })},
    {"ThirdTextureCoordinates", "scene.data",
     addChanged([](Scene& s) { s.materials[0].baseColorTexture.uvSet = 2; })},
    {"TransformNotANumber", "scene.data",
     addChanged([](Scene& s) { s.materials[0].baseColorTexture.transform[0][0] = kNan; })},
    {"TextureWithoutImage", "scene.data", addChanged([](Scene& s) { s.textures[0].image = kNone; })},
    {"ImageOutOfRange", "scene.data", addChanged([](Scene& s) { s.textures[0].image = 50; })},
    {"WrapOfNoKind", "scene.data", addChanged([](Scene& s) { s.textures[0].wrapS = Wrap(9); })},
    {"FilterOfNoKind", "scene.data", addChanged([](Scene& s) { s.textures[0].minFilter = Filter(-1); })},
    {"EmptyImage", "scene.data", addChanged([](Scene& s) { s.images[0] = {}; })},
    {"HugeImageWithoutBytes", "scene.data",
     addChanged([](Scene& s) { s.images[0].width = s.images[0].height = 100'000; })},
    {"ImageOfNegativeSize", "scene.data", addChanged([](Scene& s) { s.images[0].width = -64; })},
    {"FactorNotANumber", "scene.data", addChanged([](Scene& s) { s.materials[0].roughness = kNan; })},
    {"NegativeEmission", "scene.data", addChanged([](Scene& s) { s.materials[0].emissive.g = -1; })},
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
    {"AmbientNotANumber", "renderer.lighting", drawLit([](Lighting& l) { l.ambientColor[1] = kNan; })},
    {"SkyNotANumber", "renderer.lighting", drawLit([](Lighting& l) { l.sky[4][1] = kNan; })},
    {"InfiniteExposure", "renderer.lighting", drawLit([](Lighting& l) { l.exposure = kInfinity; })},
    {"NegativeExposure", "renderer.lighting", drawLit([](Lighting& l) { l.exposure = -1; })},
    {"AmbientOfNoKind", "permutation.range", drawLit([](Lighting& l) { l.ambient = Ambient(77); })},
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
         return stage.renderer.show({{*id}});
     }},
    {"ModelAfterRemove", "renderer.model",
     [](Stage& stage) {
         const Result<ModelId> id = stage.renderer.add(ball());
         stage.renderer.remove(*id);
         return stage.renderer.show({{*id}});
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

TEST(ManyLights, AreDrawnWithFour) {
    for (const std::size_t count : {5u, 6u, 40u, 256u, 260u}) {
        Stage stage;
        EXPECT_TRUE(stage.lit(sunny(count, 0))) << count;
        EXPECT_TRUE(stage.lit(sunny(0, count))) << count;
        EXPECT_TRUE(stage.lit(sunny(count, count))) << count;
        const Result<std::vector<ProgramUse>> uses = usesOf(ball(), sunny(count, count), {});
        ASSERT_TRUE(uses);
        EXPECT_EQ(uses->front().permutation.suns, 4);
        EXPECT_EQ(uses->front().permutation.punctualLights, 4);
    }
}

TEST(ManyLights, NearestSunsBecomeOneAndNoLightIsLost) {
    Lighting lighting;
    for (const Float3& direction :
         {Float3{1, 0, 0}, Float3{-1, 0, 0}, Float3{0, 1, 0}, Float3{0, -1, 0.1f}, Float3{0, -1, -0.1f}})
        lighting.suns.push_back({.direction = direction, .color = {1, 0.5f, 0}, .illuminance = 2});
    lighting.suns.back().illuminance = 4;
    const Lighting fitted = fittedLighting(lighting);
    ASSERT_EQ(fitted.suns.size(), 4u);
    const Sun& sum = fitted.suns[3];
    EXPECT_FLOAT_EQ(sum.color[0] * sum.illuminance, 6);
    EXPECT_FLOAT_EQ(sum.color[1] * sum.illuminance, 3);
    EXPECT_NEAR(sum.direction[1], -1, 0.01);
    EXPECT_NEAR(sum.direction[2], -0.0333, 0.001) << "weighted by irradiance";
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(fitted.suns[i].direction, lighting.suns[i].direction);
}

TEST(ManyLights, TheStrongestPunctualLightsRemain) {
    const Lighting fitted = fittedLighting(sunny(0, 9));
    ASSERT_EQ(fitted.punctualLights.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(fitted.punctualLights[i].intensity, float(6 + i));
}

TEST(ManyLights, AreToldOnce) {
    std::vector<std::string> messages;
    Renderer renderer(nullGl(), [&](LogLevel, std::string_view message) { messages.emplace_back(message); });
    for (int frame = 0; frame < 3; ++frame) {
        renderer.setLighting(sunny(5));
        renderer.setLighting(sunny(1));
    }
    EXPECT_EQ(messages.size(), 1u);
}

TEST(InvalidPermutation, HasANameAndNoProgram) {
    Permutation invalid;
    invalid.suns = 255;
    invalid.brdf = Brdf(99);
    EXPECT_NE(toName(invalid).find("suns=255"), std::string::npos) << toName(invalid);
    EXPECT_FALSE(canonicalise(invalid));
    const Gl gl = nullGl();
    ProgramCache cache(gl);
    EXPECT_EQ(cache.get(invalid).error().code, "permutation.range");
    cache.compileInBackground(invalid);
    EXPECT_EQ(cache.size(), 0u);
}

#ifdef __cpp_exceptions
[[noreturn]] void explode() { throw std::runtime_error("of the application"); }

TEST(Exceptions, OfSourcesAreErrors) {
    Stage stage;
    const Result<ModelId> model = stage.renderer.add(ball(), []() -> Result<Scene> { explode(); });
    const Result<PictureId> picture =
        stage.renderer.addPicture(white(2, 2), []() -> Result<Image> { explode(); });
    const SkyboxMap cube = whiteCube(16);
    EXPECT_TRUE(stage.renderer.setSkybox(&cube, []() -> Result<SkyboxMap> { throw 7; }));
    stage.renderer.memory().setBudget(0);
    EXPECT_TRUE(stage.renderer.memory().evictAll());
    stage.renderer.memory().setBudget(GpuMemory::kUnlimited);
    const Result<void> shown = stage.renderer.show({{*model}});
    ASSERT_FALSE(shown);
    EXPECT_EQ(shown.error().code, "renderer.exception");
    EXPECT_NE(shown.error().what.find("of the application"), std::string::npos);
    EXPECT_TRUE(stage.draw()) << "the model before is still shown";
    EXPECT_EQ(stage.renderer.frameCounters().drawn + stage.renderer.frameCounters().culled, 1u);
    const OverlayQuad quad{.picture = *picture, .place = {}};
    EXPECT_EQ(stage.renderer.drawOverlay({&quad, 1}, kTarget).error().code, "renderer.exception");
    EXPECT_EQ(stage.renderer.restore(stage.gl).error().code, "renderer.exception") << "of the skybox";
    EXPECT_TRUE(stage.draw());
}

TEST(Exceptions, OfLogAndProgressAreDropped) {
    Renderer renderer(nullGl(), [](LogLevel, std::string_view) { explode(); });
    renderer.setLighting(sunny(9));
    Scene scene = ball();
    scene.images[0] = white(8000, 1);
    EXPECT_TRUE(renderer.load(scene)) << "a warning says that it is scaled down";
    const Result<std::vector<ProgramUse>> uses = usesOf(scene, sunny(9), {});
    EXPECT_TRUE(renderer.warmUp(kTarget, *uses, [](std::size_t, std::size_t) { explode(); }));
    EXPECT_TRUE(renderer.draw({}, kTarget));
}
#endif

/// All that a kiosk does, on a driver with a fault. Each error must have a code, and say something; the codes
/// are returned.
std::vector<std::string> runOn(const Gl& gl) {
    std::vector<std::string> codes;
    const auto note = [&](const auto& result) {
        if (result)
            return;
        codes.push_back(result.error().code);
        EXPECT_FALSE(result.error().code.empty());
        EXPECT_FALSE(result.error().what.empty()) << result.error().code;
    };
    Renderer renderer(gl);
    renderer.setLighting(sunny(1, 2));
    note(renderer.load(ball(), [] { return Result<Scene>(ball()); }));
    const SkyboxMap cube = whiteCube(4);
    note(renderer.setSkybox(&cube, [] { return Result<SkyboxMap>(whiteCube(4)); }));
    const ReflectionMaps maps{.atlas = {.image = white(8, 8), .range = 1}, .lookup = white(4, 4)};
    note(renderer.setReflection(&maps));
    if (const Result<std::vector<ProgramUse>> uses = usesOf(ball(), sunny(1, 2), {}))
        note(renderer.warmUp(kTarget, *uses));
    for (int frame = 0; frame < 2; ++frame)
        note(renderer.draw({}, kTarget));
    const Result<PictureId> picture =
        renderer.addPicture(white(2, 2), [] { return Result<Image>(white(2, 2)); });
    note(picture);
    if (picture) {
        const OverlayQuad quad{.picture = *picture, .place = {0, 0, 9, 9}};
        note(renderer.drawOverlay({&quad, 1}, kTarget));
    }
    const Result<ModelId> second = renderer.add(ball());
    note(second);
    if (second)
        note(renderer.show({{*second}}));
    note(renderer.draw({}, kTarget));
    // The next context is sound.
    const Gl sound = nullGl();
    renderer.contextLost();
    EXPECT_EQ(renderer.draw({}, kTarget).error().code, "renderer.context-lost");
    static_cast<void>(renderer.restore(sound));  // What has no source is named.
    renderer.setSnippets(SnippetSet::builtIn()); // Programs that the faulty driver refused are tried again.
    EXPECT_TRUE(renderer.load(ball()));
    EXPECT_TRUE(renderer.draw({}, kTarget));
    EXPECT_EQ(renderer.frameCounters().drawn + renderer.frameCounters().culled, 1u);
    return codes;
}

std::size_t callsOfARun() {
    EXPECT_TRUE(runOn(faultyDriver(nullGl(), Fault::None, 0)).empty());
    return callsOfFaultyDriver();
}

TEST(FaultyDriver, ThatFailsAtEachCallInTurn) {
    const std::size_t calls = callsOfARun();
    EXPECT_GT(calls, 200u);
    std::size_t failed = 0;
    for (std::size_t at = 0; at < calls; ++at)
        failed += runOn(faultyDriver(nullGl(), Fault::OneCall, at)).empty() ? 0 : 1;
    std::cout << "of " << calls << " calls, " << failed << " end in an error of the library\n";
}

TEST(FaultyDriver, ThatDiesAtEachCallInTurn) {
    const std::size_t calls = callsOfARun();
    for (const Fault fault : {Fault::Dies, Fault::DiesLoudly, Fault::EndlessErrors})
        for (std::size_t at = 0; at < calls; ++at) {
            const std::vector<std::string> codes = runOn(faultyDriver(nullGl(), fault, at));
            for (const std::string& code : codes)
                EXPECT_EQ(code, "renderer.context-lost") << "fault " << int(fault) << " at call " << at;
            // Frames ask GL for nothing: a death in the last of them is for the next call to find.
            if (at < calls / 2) {
                EXPECT_FALSE(codes.empty()) << "fault " << int(fault) << " at call " << at;
            }
        }
}

TEST(FaultyDriver, ThatMakesNoObjects) {
    const std::vector<std::string> codes = runOn(faultyDriver(nullGl(), Fault::NoNames, 0));
    ASSERT_FALSE(codes.empty());
    EXPECT_EQ(codes.front(), "gl.object");
}

TEST(MemoryOfTheGpu, IsFreedAndAskedForOnceMore) {
    static int refusals;
    refusals = 0;
    static bool owesError = false;
    Gl gl = nullGl();
    gl.TexImage2D = [](GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {
        owesError = refusals > 0;
        refusals -= owesError ? 1 : 0;
    };
    gl.GetError = []() -> GLenum { return std::exchange(owesError, false) ? GL_OUT_OF_MEMORY : GL_NO_ERROR; };
    Renderer renderer(gl);
    const SceneSource source = [] { return Result<Scene>(ball()); };
    const Result<ModelId> hidden = renderer.add(ball(), source);
    ASSERT_TRUE(hidden);
    refusals = 100;
    EXPECT_EQ(renderer.add(ball(), source).error().code, "renderer.memory");
    EXPECT_EQ(renderer.memory().evictions(), 1u) << "the hidden model";
    refusals = 0;
    ASSERT_TRUE(renderer.show({{*hidden}}));
    EXPECT_TRUE(renderer.draw({}, kTarget));
}

} // namespace
} // namespace franken::test
