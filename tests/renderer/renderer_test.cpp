// SPDX-License-Identifier: MIT
// What the renderer asks of GL, and which programs it makes.
#include "support/draw_scene.h"
#include "support/shapes.h"

namespace franken::test {
namespace {

class RendererTest : public PictureTest {};

INSTANTIATE_TEST_SUITE_P(Backends, RendererTest, allBackends(), backendName);

Shot ballShot(const Material& material) {
    SceneBuilder builder;
    builder.add(sphere(12), builder.addMaterial(material));
    builder.addSun({-1, -1, -1}, {1, 1, 1}, 3);
    return {.scene = builder.scene,
            .camera = framingCamera(builder.scene.bounds(), 1),
            .lighting = lightingOf(builder.scene)};
}

int calls = 0; // Of functions that wait for the driver, or compile.

/// The table of a driver that counts calls that have no place in a frame.
Gl countingGl(const Gl& gl) {
    static Gl plain;
    plain = gl;
    Gl counting = gl;
    counting.GetError = [] { return ++calls, plain.GetError(); };
    counting.GetIntegerv = [](GLenum name, GLint* value) { ++calls, plain.GetIntegerv(name, value); };
    counting.GetUniformLocation = [](GLuint program, const GLchar* name) {
        return ++calls, plain.GetUniformLocation(program, name);
    };
    counting.GetProgramiv = [](GLuint program, GLenum name, GLint* value) {
        ++calls, plain.GetProgramiv(program, name, value);
    };
    counting.CompileShader = [](GLuint shader) { ++calls, plain.CompileShader(shader); };
    counting.LinkProgram = [](GLuint program) { ++calls, plain.LinkProgram(program); };
    return counting;
}

TEST_P(RendererTest, AFrameAsksNothing) {
    const Gl counting = countingGl(gl());
    Shot shot = ballShot({});
    Renderer renderer(counting);
    ASSERT_TRUE(renderer.load(shot.scene));
    renderer.setLighting(shot.lighting);
    ASSERT_TRUE(renderer.prepare());
    calls = 0;
    for (int frame = 0; frame < 3; ++frame) {
        shot.lighting.suns[0].direction[0] += 0.1f;
        renderer.setLighting(shot.lighting);
        ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), {surface().framebuffer(), 64, 64}));
    }
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(RendererTest, AnotherOutputCompilesNoVertexShader) {
    const Shot shot = ballShot({});
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(shot.scene));
    renderer.setLighting(shot.lighting);
    ASSERT_TRUE(renderer.prepare());
    EXPECT_EQ(renderer.programCounters().compiles, 2u);
    renderer.setLook({.output = Output::Pow22});
    ASSERT_TRUE(renderer.prepare());
    EXPECT_EQ(renderer.programCounters().compiles, 3u);
    EXPECT_EQ(renderer.programCounters().links, 2u);
    renderer.setLook({});
    ASSERT_TRUE(renderer.prepare());
    EXPECT_EQ(renderer.programCounters().links, 2u);
    EXPECT_EQ(renderer.programCounters().hits, 1u);
}

TEST_P(RendererTest, FramesAreTheSameWhateverGlWasLeftAt) {
    Material material;
    material.alphaMode = AlphaMode::Blend;
    material.factors.baseColor[3] = 0.5f;
    const Shot shot = ballShot(material);
    const Picture clean = draw(shot);
    disturbState(gl());
    EXPECT_EQ(compareLit(draw(shot), clean).max(), 0);
}

TEST_P(RendererTest, AShaderThatTheDriverRefusesIsAnErrorWithItsLog) {
    static Gl plain;
    plain = gl();
    Gl refusing = gl();
    refusing.ShaderSource = [](GLuint shader, GLsizei, const GLchar* const*, const GLint*) {
        const char* const broken = "#version 100\nvoid main() { nonsense; }\n";
        plain.ShaderSource(shader, 1, &broken, nullptr);
    };
    ProgramCache cache(refusing);
    for (int attempt = 0; attempt < 2; ++attempt) {
        const Result<ProgramHandle> program = cache.get(Permutation{});
        ASSERT_FALSE(program);
        EXPECT_EQ(program.error().code, "program.compile");
        EXPECT_NE(program.error().what.find("nonsense"), std::string::npos) << program.error().what;
        EXPECT_NE(program.error().where.find("surface"), std::string::npos);
    }
    EXPECT_EQ(cache.counters().compiles, 2u) << "both stages once: what failed is not tried again";
    EXPECT_EQ(cache.counters().failures, 1u);
}

TEST_P(RendererTest, ALargeMeshIsSplitWhereIndicesAreNarrow) {
    Shot shot = ballShot({});
    shot.scene.meshes[0].primitives[0] = sphere(200); // 80,601 vertices.
    const Picture wide = draw(shot);
    Renderer renderer(gl(), {.maxTextureSize = 2048});
    ASSERT_TRUE(renderer.load(shot.scene));
    renderer.setLighting(shot.lighting);
    ASSERT_TRUE(renderer.draw(viewpointOf(shot.camera, 1), {surface().framebuffer(), 64, 64}));
    EXPECT_EQ(compareLit(readBack(), wide).max(), 0);
}

} // namespace
} // namespace franken::test
