// SPDX-License-Identifier: MIT
// A picture that shares the screen and the context with others: areas, what is cleared, turned panels, and
// the state of GL.
#include "franken/png.h"
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace franken::test {
namespace {

class SharingTest : public PictureTest {
protected:
    SharingTest() : PictureTest({64, 48}) {}

    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = 64, .height = 48}; }

    /// Balls of three colours before a sky, none of which a turn leaves as it is.
    void load(Renderer& renderer) {
        SceneBuilder builder;
        const std::array<Float4, 3> colors = {Float4{1, 0.1f, 0.1f, 1}, {0.1f, 1, 0.1f, 1}, {1, 1, 0, 0.5f}};
        for (std::size_t i = 0; i < colors.size(); ++i) {
            Material material;
            material.factors.baseColor = colors[i];
            material.alphaMode = i == 2 ? AlphaMode::Blend : AlphaMode::Opaque;
            material.textures[TextureRole::BaseColor].texture =
                builder.addTexture(checkers(8, 4, glm::vec4(1), glm::vec4(0.5f)));
            glm::mat4 world(0.5f);
            world[3] = glm::vec4(0.8f * static_cast<float>(i) - 0.8f, 0.3f * static_cast<float>(i), 0, 1);
            builder.add(sphere(8), builder.addMaterial(material), world);
        }
        ASSERT_TRUE(renderer.load(builder.scene));
        Lighting lighting;
        lighting.suns = {{.direction = {-1, -1, -1}, .illuminance = 3}};
        renderer.setLighting(lighting);
    }

    void addSky(Renderer& renderer) {
        Environment sky{Environment::Layout::Equirect, 8, 4, {}};
        for (int i = 0; i < 32; ++i)
            sky.texels.emplace_back(0.03f * static_cast<float>(i), 0.1f * static_cast<float>(i % 8), 0.3f);
        const SkyboxMap cube = encodeSkybox(sky, 16);
        ASSERT_TRUE(renderer.setSkybox(&cube));
    }

    Viewpoint viewpoint(const DrawTarget& drawn) {
        Camera camera;
        camera.world[3] = glm::vec4(0.2, 0.1, 3, 1);
        return viewpointOf(camera, aspectOf(drawn));
    }

    Picture drawn(Renderer& renderer, const DrawTarget& at) {
        const Result<void> result = renderer.draw(viewpoint(at), at);
        EXPECT_TRUE(result) << toString(result.error());
        return readBack();
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, SharingTest, allBackends(), backendName);

ReadBack::Pixel pixel(const Picture& picture, int x, int y) {
    ReadBack image;
    static_cast<Image&>(image) = picture;
    return image.pixel(x, y);
}

/// Counter-clockwise by a quarter: what a panel shows that is mounted clockwise by one.
Picture quarter(const Picture& from) {
    Picture to{"", from.height, from.width, std::vector<std::uint8_t>(from.rgba.size())};
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            for (int c = 0; c < 4; ++c)
                to.rgba[static_cast<std::size_t>(4 * (y * to.width + x) + c)] =
                    from.rgba[static_cast<std::size_t>(4 * (x * from.width + from.width - 1 - y) + c)];
    return to;
}

TEST_P(SharingTest, AnAreaIsAPictureOfItsOwn) {
    Renderer renderer(gl());
    load(renderer);
    addSky(renderer);
    gl().ClearColor(0, 0, 1, 1);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    renderer.invalidateState();
    DrawTarget right = target();
    right.area = TargetArea{32, 8, 24, 32};
    const Picture picture = drawn(renderer, right);
    for (const auto& [x, y] : {std::pair(31, 20), {56, 20}, {40, 7}, {40, 40}, {0, 0}})
        EXPECT_EQ(pixel(picture, x, y), (ReadBack::Pixel{0, 0, 255, 255})) << x << ", " << y;
    const Result<Image> area = renderer.readPixels(right);
    ASSERT_TRUE(area);
    EXPECT_EQ(area->width, 24);
    EXPECT_EQ(pixel(*area, 0, 0), pixel(picture, 32, 8));
    EXPECT_EQ(pixel(*area, 23, 31), pixel(picture, 55, 39));

    DrawTarget left = target();
    left.area = TargetArea{0, 8, 24, 32};
    drawn(renderer, left);
    const Result<Image> other = renderer.readPixels(left), again = renderer.readPixels(right);
    ASSERT_TRUE(other && again);
    EXPECT_LE(compareLit(*other, *area).max(), 1) << "the same picture beside it";
    EXPECT_EQ(compareLit(*again, *area).max(), 0) << "which stays";
}

TEST_P(SharingTest, WhatIsNotClearedIsDrawnOver) {
    Renderer renderer(gl());
    load(renderer);
    DrawTarget at = target();
    at.background = {0.2f, 0.1f, 0};
    at.backgroundAlpha = 0.25f;
    const Picture cleared = drawn(renderer, at);
    EXPECT_EQ(pixel(cleared, 0, 0), (ReadBack::Pixel{51, 26, 0, 64}));
    EXPECT_EQ(pixel(cleared, 32, 24)[3], 255) << "surfaces cover what is below";
    gl().ClearColor(0, 0, 1, 1);
    gl().ClearDepthf(0);
    gl().DepthMask(GL_TRUE);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    renderer.invalidateState();
    at.clear = Clear::Nothing;
    EXPECT_EQ(pixel(drawn(renderer, at), 32, 24), (ReadBack::Pixel{0, 0, 255, 255})) << "nothing is nearer";
    at.clear = Clear::Depth;
    const Picture over = drawn(renderer, at);
    EXPECT_EQ(pixel(over, 0, 0), (ReadBack::Pixel{0, 0, 255, 255}));
    EXPECT_EQ(pixel(over, 32, 24), pixel(cleared, 32, 24));
}

TEST_P(SharingTest, ATurnedPictureIsTheSamePicture) {
    Renderer renderer(gl());
    load(renderer);
    addSky(renderer);
    const Result<PictureId> picture = renderer.addPicture(checkers(4, 2, {1, 0, 0, 1}, {0, 1, 1, 1}));
    ASSERT_TRUE(picture);
    const std::vector<OverlayQuad> quads = {{.picture = *picture, .place = {2, 4, 8, 4}}};
    const auto shown = [&](Rotation rotation, TargetArea area) {
        DrawTarget at = target();
        at.area = area;
        at.rotation = rotation;
        drawn(renderer, at);
        EXPECT_TRUE(renderer.drawOverlay(quads, at));
        Result<Image> image = renderer.readPixels(at);
        EXPECT_TRUE(image);
        return *image;
    };
    const Picture upright = shown(Rotation::None, {0, 0, 48, 32});
    EXPECT_EQ(pixel(upright, 3, 5), (ReadBack::Pixel{255, 0, 0, 255}));
    Picture expected = upright;
    for (const Rotation rotation : {Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters}) {
        expected = quarter(expected);
        const Picture turned = shown(rotation, {0, 0, expected.width, expected.height});
        // Edges and texels are sampled at the other end of a rounding.
        const Difference difference = compareLit(turned, expected);
        EXPECT_LE(difference.shareAbove(2), 0.02) << toDegrees(rotation) << ": " << difference
                                                 << writeDifference("turned", turned, expected);
    }
}

// Names of OpenGL ES 3.0, which both backends have.
constexpr GLenum kReadFramebuffer = 0x8CA8, kPackBuffer = 0x88EB, kUnpackBuffer = 0x88EC;
constexpr std::array<GLenum, 9> kNewer = {
    0x8CAA, 0x88ED, 0x88EF, // Bindings of the read framebuffer and of the buffers of packing and unpacking.
    0x0D02, 0x0D03, 0x0D04, // Packing: row length, rows and pixels to skip.
    0x0CF2, 0x0CF3, 0x0CF4, // Unpacking: likewise.
};

/// All that the library touches, asked one by one, in an order of the test's own.
std::vector<double> stateOf(const Gl& gl) {
    std::vector<double> state;
    for (const GLenum name :
         {GL_ACTIVE_TEXTURE, GL_ARRAY_BUFFER_BINDING, GL_BLEND_DST_ALPHA, GL_BLEND_DST_RGB,
          GL_BLEND_EQUATION_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_SRC_RGB,
          GL_CULL_FACE_MODE, GL_CURRENT_PROGRAM, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK,
          GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_FRAMEBUFFER_BINDING, GL_FRONT_FACE, GL_PACK_ALIGNMENT,
          GL_RENDERBUFFER_BINDING, GL_UNPACK_ALIGNMENT, GL_VIEWPORT, GL_SCISSOR_BOX, GL_COLOR_CLEAR_VALUE,
          GL_COLOR_WRITEMASK, GL_DEPTH_CLEAR_VALUE, GL_DEPTH_RANGE, GL_STENCIL_FUNC, GL_LINE_WIDTH,
          GL_BLEND_COLOR, GL_POLYGON_OFFSET_FACTOR}) {
        std::array<GLfloat, 4> values{};
        gl.GetFloatv(name, values.data());
        state.insert(state.end(), values.begin(), values.end());
    }
    for (const GLenum name : kNewer) {
        GLint value = 0;
        gl.GetIntegerv(name, &value);
        state.push_back(value);
    }
    for (const GLenum name : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_POLYGON_OFFSET_FILL,
                              GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_SCISSOR_TEST, GL_STENCIL_TEST})
        state.push_back(gl.IsEnabled(name));
    GLint unit = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
    for (GLenum each = 0; each < 8; ++each) {
        gl.ActiveTexture(GL_TEXTURE0 + each);
        for (const GLenum name : {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_CUBE_MAP}) {
            GLint texture = 0;
            gl.GetIntegerv(name, &texture);
            state.push_back(texture);
        }
    }
    gl.ActiveTexture(static_cast<GLenum>(unit));
    for (GLuint location = 0; location < 8; ++location) {
        for (const GLenum name :
             {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_ARRAY_SIZE,
              GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_STRIDE}) {
            GLint value = 0;
            gl.GetVertexAttribiv(location, name, &value);
            state.push_back(value);
        }
        void* pointer = nullptr;
        gl.GetVertexAttribPointerv(location, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
        state.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer)));
    }
    return state;
}

/// What OpenGL ES 3.0 adds: pictures that go through buffers, in rows of other lengths.
void setOddTransfers(const Gl& gl) {
    GLuint framebuffer = 0;
    std::array<GLuint, 2> buffers{};
    gl.GenFramebuffers(1, &framebuffer);
    gl.GenBuffers(2, buffers.data());
    gl.BindFramebuffer(kReadFramebuffer, framebuffer);
    gl.BindBuffer(kPackBuffer, buffers[0]);
    gl.BindBuffer(kUnpackBuffer, buffers[1]);
    for (std::size_t i = 3; i < kNewer.size(); ++i)
        gl.PixelStorei(kNewer[i], 70 + static_cast<GLint>(i));
}

/// Objects and numbers as a toolkit has them, none of them GL's own first ones.
void setOddState(const Gl& gl) {
    disturbState(gl);
    setOddTransfers(gl);
    std::array<GLuint, 3> buffers{}, textures{};
    GLuint renderbuffer = 0;
    gl.GenBuffers(3, buffers.data());
    gl.GenTextures(3, textures.data());
    gl.GenRenderbuffers(1, &renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    for (GLuint location = 0; location < 8; ++location) {
        gl.BindBuffer(GL_ARRAY_BUFFER, buffers[location % 3]);
        gl.VertexAttribPointer(location, 1 + static_cast<GLint>(location % 4), GL_SHORT, location % 2 == 0, 24,
                               reinterpret_cast<const void*>(static_cast<std::uintptr_t>(4 * location)));
    }
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
    gl.ActiveTexture(GL_TEXTURE3);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, textures[0]);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, textures[1]);
    gl.ActiveTexture(GL_TEXTURE7);
    gl.BindTexture(GL_TEXTURE_2D, textures[2]);
    gl.ActiveTexture(GL_TEXTURE5);
    gl.BlendEquationSeparate(GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT);
    gl.BlendFuncSeparate(GL_ONE, GL_DST_COLOR, GL_ZERO, GL_DST_ALPHA);
    gl.ClearColor(0.25f, 0.5f, 0.75f, 0.125f);
    gl.ClearDepthf(0.5f);
    gl.DepthRangef(0.25f, 0.75f);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 2);
    gl.Scissor(5, 6, 7, 8);
    gl.Disable(GL_DITHER);
    gl.Enable(GL_SAMPLE_COVERAGE);
}

TEST_P(SharingTest, ARendererThatIsMadeLeavesGlAsItWas) {
    setOddState(gl());
    const std::vector<double> before = stateOf(gl());
    const Precision precision = Capabilities::query(gl()).precision;
    EXPECT_EQ(stateOf(gl()), before);
    EXPECT_EQ(precision, Precision::Fp32);
    Renderer renderer(gl());
    EXPECT_EQ(stateOf(gl()), before);
    ASSERT_TRUE(renderer.acquireState());
    load(renderer);
    ASSERT_TRUE(renderer.releaseState());
    renderer.contextLost();
    EXPECT_EQ(renderer.restore(gl()).error().code, "renderer.no-source");
    EXPECT_EQ(stateOf(gl()), before);
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(SharingTest, GlIsHandedBackAsItWas) {
    Renderer renderer(gl());
    EXPECT_EQ(renderer.releaseState().error().code, "renderer.state");
    load(renderer);
    addSky(renderer);
    const Picture clean = drawn(renderer, target());
    for (int frame = 0; frame < 2; ++frame) {
        setOddState(gl());
        const std::vector<double> before = stateOf(gl());
        ASSERT_TRUE(renderer.acquireState());
        DrawTarget at = target();
        at.area = TargetArea{0, 0, 64, 48};
        ASSERT_TRUE(renderer.draw(viewpoint(at), at));
        ASSERT_TRUE(renderer.readPixels(at));
        EXPECT_EQ(compareLit(*renderer.readPixels(at), clean).max(), 0);
        const Result<PictureId> picture = renderer.addPicture(checkers(4, 2, {1, 0, 0, 1}, {0, 1, 1, 1}));
        ASSERT_TRUE(picture);
        ASSERT_TRUE(renderer.drawOverlay({{{.picture = *picture, .place = {0, 0, 4, 4}}}}, at));
        const Result<Image> covered = renderer.readPixels(at);
        ASSERT_TRUE(covered);
        EXPECT_EQ(pixel(*covered, 0, 0), (ReadBack::Pixel{255, 0, 0, 255}));
        EXPECT_EQ(pixel(*covered, 3, 0), (ReadBack::Pixel{0, 255, 255, 255}));
        renderer.setLook({.toneMap = frame == 0 ? ToneMap::Aces : ToneMap::Neutral});
        ASSERT_TRUE(renderer.draw(viewpoint(at), at)) << "with programs that are compiled and proved";
        renderer.setLook({});
        EXPECT_NE(stateOf(gl()), before);
        ASSERT_TRUE(renderer.releaseState());
        EXPECT_EQ(stateOf(gl()), before) << "frame " << frame;
        EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
    }
    renderer.contextLost();
    EXPECT_EQ(renderer.acquireState().error().code, "renderer.context-lost");
    EXPECT_EQ(renderer.readPixels(target()).error().code, "renderer.context-lost");
}

TEST_P(SharingTest, TargetsThatCannotBeAreRefused) {
    Renderer renderer(gl());
    const auto codeOf = [&](const auto& change) {
        DrawTarget at = target();
        change(at);
        return renderer.draw({}, at).error().code + " " + renderer.readPixels(at).error().code;
    };
    const std::string refused = "renderer.target renderer.target";
    for (const TargetArea area : {TargetArea{0, 0, 0, 4}, {-1, 0, 4, 4}, {60, 0, 5, 4}, {0, 45, 4, 4},
                                  {std::numeric_limits<int>::max(), 0, 4, 4}, {1, 1, std::numeric_limits<int>::max(), 4}})
        EXPECT_EQ(codeOf([&](DrawTarget& at) { at.area = area; }), refused) << area.x << " " << area.width;
    EXPECT_EQ(codeOf([](DrawTarget& at) { at.backgroundAlpha = 2; }), refused);
    EXPECT_EQ(codeOf([](DrawTarget& at) { at.backgroundAlpha = std::numeric_limits<float>::quiet_NaN(); }), refused);
    EXPECT_EQ(codeOf([](DrawTarget& at) { at.clear = static_cast<Clear>(7); }), refused);
    EXPECT_EQ(codeOf([](DrawTarget& at) { at.rotation = static_cast<Rotation>(-1); }), refused);
}

TEST_P(SharingTest, APictureIsWrittenAsPng) {
    Renderer renderer(gl());
    DrawTarget at = target();
    at.background = {0, 0.5f, 0};
    at.backgroundAlpha = 0.5f;
    drawn(renderer, at);
    const Result<Image> image = renderer.readPixels(at);
    ASSERT_TRUE(image);
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / (backendName({GetParam(), 0}) + ".png");
    const auto written = [&] {
        std::ifstream in(path, std::ios::binary);
        const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
        return pixel(*decodeImage(bytes), 9, 9);
    };
    ASSERT_TRUE(writePng(path, *image, PngChannels::Rgba));
    EXPECT_EQ(written(), (ReadBack::Pixel{0, 128, 0, 128}));
    ASSERT_TRUE(writePng(path, *image));
    EXPECT_EQ(written(), (ReadBack::Pixel{0, 128, 0, 255}));
    EXPECT_EQ(writePng(path, Image{"", 3, 3, {1, 2}}).error().code, "image.pixels");
    EXPECT_EQ(writePng("/nowhere/picture.png", *image).error().code, "file.write");
}

} // namespace
} // namespace franken::test
