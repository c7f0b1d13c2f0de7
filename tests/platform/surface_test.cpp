// SPDX-License-Identifier: MIT
#include "franken/gl_object.h"
#include "support/offscreen.h"

#include <cstdlib>
#include <thread>

namespace franken::test {
namespace {

using platform::Backend;
using Pixel = ReadBack::Pixel;

constexpr Pixel kBlack = {0, 0, 0, 0};
constexpr Pixel kGreen = {0, 255, 0, 255};
constexpr Pixel kRed = {255, 0, 0, 255};

constexpr const char* kVertex = R"(#version 100
precision highp float;
attribute vec4 position;
void main() {
    gl_Position = position;
    gl_PointSize = 16.0;
}
)";

std::string fragment(std::string_view colour, std::string_view declarations = "") {
    return "#version 100\n#ifdef GL_FRAGMENT_PRECISION_HIGH\nprecision highp float;\n#else\n"
           "precision mediump float;\n#endif\n" +
           std::string(declarations) + "void main() { gl_FragColor = " + std::string(colour) + "; }\n";
}

GlShader compile(const Gl& gl, GLenum stage, const char* source) {
    GlShader shader(gl, gl.CreateShader(stage));
    gl.ShaderSource(shader.name(), 1, &source, nullptr);
    gl.CompileShader(shader.name());
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    return compiled ? std::move(shader) : GlShader();
}

/// Compiles, links and uses; 0 where the driver refuses.
GlProgram use(const Gl& gl, const std::string& fragmentSource) {
    const GlShader vertex = compile(gl, GL_VERTEX_SHADER, kVertex);
    const GlShader fragment = compile(gl, GL_FRAGMENT_SHADER, fragmentSource.c_str());
    if (!vertex || !fragment)
        return {};
    GlProgram program(gl, gl.CreateProgram());
    gl.AttachShader(program.name(), vertex.name());
    gl.AttachShader(program.name(), fragment.name());
    gl.BindAttribLocation(program.name(), 0, "position");
    gl.LinkProgram(program.name());
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (!linked)
        return {};
    gl.UseProgram(program.name());
    return program;
}

/// x and y of each vertex, in normalised device coordinates.
void draw(const Gl& gl, GLenum mode, const std::vector<float>& positions) {
    GlBuffer buffer(gl, generate(gl.GenBuffers));
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(float)),
                  positions.data(), GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.DrawArrays(mode, 0, static_cast<GLsizei>(positions.size() / 2));
}

const std::vector<float> kWholeTarget = {-1, -1, 3, -1, -1, 3};

using SurfaceTest = OffscreenTest;
INSTANTIATE_TEST_SUITE_P(Backends, SurfaceTest, allBackends(), backendName);

TEST_P(SurfaceTest, ComesUpAndSaysWhatItIs) {
    EXPECT_EQ(surface().backend(), GetParam());
    EXPECT_EQ(surface().size(), (platform::Size{64, 64}));
    EXPECT_FALSE(surface().srgbTarget());
    EXPECT_EQ(surface().samples(), 0);
    EXPECT_NE(surface().driver().find(std::getenv("GALLIUM_DRIVER")), std::string::npos)
        << surface().driver();
    RecordProperty("driver", surface().driver());
    GLint depthBits = 0;
    gl().GetIntegerv(GL_DEPTH_BITS, &depthBits);
    EXPECT_GE(depthBits, 24);
    ASSERT_TRUE(surface().begin().value());
    EXPECT_TRUE(surface().submit());
    EXPECT_FALSE(surface().begin().value()); // One frame at a time.
    EXPECT_EQ(surface().dispatch().completed->sequence, 1u);
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(SurfaceTest, SaysHowManySamplesItsTargetHas) {
    Result<Offscreen> smooth = openOffscreen(GetParam(), {16, 16}, 4);
    ASSERT_TRUE(smooth) << toString(smooth.error());
    GLint samples = -1;
    smooth->gl.GetIntegerv(GL_SAMPLES, &samples);
    EXPECT_EQ(smooth->surface->samples(), samples);
}

TEST_P(SurfaceTest, DrawsATriangleTheRightWayUp) {
    const GlProgram program = use(gl(), fragment("vec4(0.25, 0.5, 1.0, 0.75)"));
    ASSERT_TRUE(program);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    draw(gl(), GL_TRIANGLES, {-1, -1, 1, -1, -1, 1}); // The lower left half.
    const ReadBack image = readBack();
    EXPECT_EQ(image.pixel(0, 63), (Pixel{64, 128, 255, 191}));
    EXPECT_EQ(image.pixel(20, 40), (Pixel{64, 128, 255, 191}));
    EXPECT_EQ(image.pixel(1, 0), kBlack);
    EXPECT_EQ(image.pixel(63, 0), kBlack);
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(SurfaceTest, KeepsTheRulesOfEs100) {
    EXPECT_FALSE(use(gl(), "#version 100\nvoid main() { float a = 1.0; gl_FragColor = vec4(a); }"));
    EXPECT_FALSE(use(gl(), fragment("vec4(0.5 * 2)")));
    EXPECT_TRUE(use(gl(), fragment("vec4(1.0)", "#ifndef GL_FRAGMENT_PRECISION_HIGH\n#error\n#endif\n")));
}

TEST_P(SurfaceTest, TellsFrontFromBack) {
    const GlProgram program =
        use(gl(), fragment("gl_FrontFacing ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0)"));
    ASSERT_TRUE(program);
    draw(gl(), GL_TRIANGLES, kWholeTarget);
    EXPECT_EQ(readBack().pixel(32, 32), kGreen);
    draw(gl(), GL_TRIANGLES, {-1, -1, -1, 3, 3, -1});
    EXPECT_EQ(readBack().pixel(32, 32), kRed);
}

TEST_P(SurfaceTest, SizesPointsInTheShader) {
    const GlProgram program = use(gl(), fragment("vec4(step(0.5, gl_PointCoord), 0.0, 1.0)"));
    ASSERT_TRUE(program);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    draw(gl(), GL_POINTS, {0, 0});
    const ReadBack image = readBack();
    EXPECT_EQ(image.pixel(25, 25), (Pixel{0, 0, 0, 255})); // gl_PointCoord counts from the top left.
    EXPECT_EQ(image.pixel(38, 25), kRed);
    EXPECT_EQ(image.pixel(25, 38), kGreen);
    EXPECT_EQ(image.pixel(22, 32), kBlack);
}

TEST_P(SurfaceTest, FiltersAcrossTheFacesOfACube) {
    const GlTexture cube(gl(), generate(gl().GenTextures));
    gl().BindTexture(GL_TEXTURE_CUBE_MAP, cube.name());
    gl().TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (GLenum face = 0; face < 6; ++face) {
        const std::vector<GLubyte> texels(16, face == 2 ? 200 : 0); // +Y is bright.
        gl().TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
    }
    const GlProgram program =
        use(gl(), fragment("textureCube(cube, vec3(1.0, 0.99, 0.0))", "uniform samplerCube cube;\n"));
    ASSERT_TRUE(program);
    draw(gl(), GL_TRIANGLES, kWholeTarget);
    // 2x2 texels: 0.99 is 0.99 / 2 + 0.5 = 0.995 of the face, 0.49 texels past the last centre.
    EXPECT_NEAR(readBack().pixel(32, 32)[0], 0.49 * 200, 1.0);
}

TEST_P(SurfaceTest, StaysAsItWasWhenAnotherOneGoes) {
    const GlProgram program = use(gl(), fragment("vec4(0.0, 1.0, 0.0, 1.0)"));
    for (const Backend other : {Backend::OsMesa, Backend::EglSurfaceless}) {
        Result<Offscreen> second = openOffscreen(other, {16, 16});
        ASSERT_TRUE(second) << toString(second.error());
        second->gl.ClearColor(1, 0, 0, 1);
        second->gl.Clear(GL_COLOR_BUFFER_BIT);
        ASSERT_TRUE(surface().makeCurrent());
        draw(gl(), GL_TRIANGLES, kWholeTarget);
        ASSERT_TRUE(second->surface->makeCurrent());
        EXPECT_EQ(test::readBack(*second).pixel(8, 8), kRed);
        ASSERT_TRUE(surface().makeCurrent());
        second->surface.reset();
        EXPECT_EQ(readBack().pixel(32, 32), kGreen);
        EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
    }
}

TEST_P(SurfaceTest, ComesAndGoesAgainAndAgain) {
    for (int round = 0; round < 8; ++round)
        for (const Backend backend : {Backend::OsMesa, Backend::EglSurfaceless}) {
            Result<Offscreen> next = openOffscreen(backend, {8 + round, 8});
            ASSERT_TRUE(next) << toString(next.error());
            const GlProgram program = use(next->gl, fragment("vec4(0.0, 1.0, 0.0, 1.0)"));
            draw(next->gl, GL_TRIANGLES, kWholeTarget);
            EXPECT_EQ(test::readBack(*next).pixel(7 + round, 7), kGreen);
        }
}

TEST_P(SurfaceTest, WorksInAnotherThread) {
    std::thread([backend = GetParam()] {
        Result<Offscreen> other = openOffscreen(backend, {16, 16});
        ASSERT_TRUE(other) << toString(other.error());
        other->gl.ClearColor(1, 0, 0, 1);
        other->gl.Clear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(test::readBack(*other).pixel(8, 8), kRed);
    }).join();
    gl().ClearColor(0, 1, 0, 1);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(readBack().pixel(8, 8), kGreen);
}

TEST_P(SurfaceTest, TellsTheLogWhatDraws) {
    std::string message;
    const platform::SurfaceOptions options = {
        .size = {4, 4}, .log = [&](LogLevel, std::string_view text) { message = text; }};
    ASSERT_TRUE(platform::create(GetParam(), options));
    EXPECT_EQ(message, backendName({GetParam(), 0}) + ": " + surface().driver());
}

TEST(EglSurface, IsRefusedToASecondThread) {
    const Result<Offscreen> held = openOffscreen(Backend::EglSurfaceless, {8, 8});
    ASSERT_TRUE(held) << toString(held.error());
    std::thread([&held] {
        const Result<void> current = held->surface->makeCurrent();
        ASSERT_FALSE(current);
        EXPECT_EQ(current.error().code, "surface.driver");
    }).join();
    held->gl.ClearColor(0, 1, 0, 1);
    held->gl.Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(readBack(*held).pixel(4, 4), kGreen);
}

struct Refused {
    platform::Size size;
    int depthBits, samples;
    const char* where;
};

constexpr Refused kRefused[] = {
    {{0, 16}, 24, 0, "0x16"},         {{16, -1}, 24, 0, "16x-1"},
    {{8193, 1}, 24, 0, "8193x1"},     {{1, 1 << 30}, 24, 0, "1x1073741824"},
    {{16, 16}, -1, 0, "-1 bits"},     {{16, 16}, 33, 0, "33 bits"},
    {{16, 16}, 24, -1, "-1 samples"}, {{16, 16}, 24, 17, "17 samples"},
};

TEST(SurfaceOptions, OutOfRangeAreRefusedByName) {
    for (const auto& [size, depthBits, samples, where] : kRefused)
        for (const Backend backend : {Backend::OsMesa, Backend::EglSurfaceless}) {
            SCOPED_TRACE(where);
            const auto surface =
                platform::create(backend, {.size = size, .depthBits = depthBits, .samples = samples});
            ASSERT_FALSE(surface);
            EXPECT_EQ(surface.error().code, "surface.options");
            EXPECT_EQ(surface.error().where, where);
            EXPECT_FALSE(surface.error().remedy.empty());
        }
}

TEST(SurfaceOptions, TheShaderCacheGoesToMesaUnlessTheEnvironmentHasOne) {
    unsetenv("MESA_SHADER_CACHE_DIR");
    (void)openOffscreen(Backend::OsMesa, {1, 1}); // With the tests' rasteriser.
    EXPECT_EQ(std::getenv("MESA_SHADER_CACHE_DIR"), nullptr);
    for (const char* folder : {"/var/cache/kiosk", "/elsewhere"}) {
        (void)platform::create(Backend::OsMesa, {.size = {1, 1}, .shaderCache = folder});
        EXPECT_STREQ(std::getenv("MESA_SHADER_CACHE_DIR"), "/var/cache/kiosk");
    }
    unsetenv("MESA_SHADER_CACHE_DIR");
}

TEST(BackendNames, GoThereAndBack) {
    for (const Backend backend : {Backend::OsMesa, Backend::EglSurfaceless, Backend::Kms, Backend::Window})
        EXPECT_EQ(platform::parseBackend(platform::toString(backend)).value(), backend);
}

TEST(BackendNames, AreListedWhereOneIsWrong) {
    const Result<Backend> backend = platform::parseBackend("glx");
    ASSERT_FALSE(backend);
    EXPECT_EQ(toString(backend.error()),
              "glx: there is no such backend (choose one of osmesa, egl, kms, window) [surface.backend]");
}

} // namespace
} // namespace franken::test
