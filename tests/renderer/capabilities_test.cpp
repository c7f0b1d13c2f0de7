// SPDX-License-Identifier: MIT
// The same pictures on a context that can do no more than GLES2 promises.
#include "support/draw_scene.h"
#include "support/gl_recorder.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>

namespace franken::test {
namespace {

struct Message {
    LogLevel level;
    std::string text;
};

class CapabilitiesTest : public PictureTest {
protected:
    /// The scene from 3 m before its origin, by a renderer that believes in those capabilities.
    Picture drawn(const Scene& scene, const Capabilities& capabilities) {
        m_messages.clear();
        Renderer renderer(gl(), capabilities, [this](LogLevel level, std::string_view text) {
            m_messages.push_back({level, std::string(text)});
        });
        EXPECT_TRUE(renderer.load(scene));
        Camera camera;
        camera.world[3] = glm::vec4(0, 0, 3, 1);
        const Result<void> result = renderer.draw(
            viewpointOf(camera, 1), {.framebuffer = surface().framebuffer(), .width = 64, .height = 64});
        EXPECT_TRUE(result) << toString(result.error());
        EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
        return readBack();
    }

    std::vector<Message> m_messages;
};

INSTANTIATE_TEST_SUITE_P(Backends, CapabilitiesTest, allBackends(), backendName);

constexpr Capabilities kLeast = {.maxTextureSize = 64};
constexpr Capabilities kMost = {.maxTextureSize = 4096, .anyTextureSize = true, .wideIndices = true};

constexpr Filter kFilters[] = {Filter::Nearest,
                               Filter::Linear,
                               Filter::NearestMipmapNearest,
                               Filter::LinearMipmapNearest,
                               Filter::NearestMipmapLinear,
                               Filter::LinearMipmapLinear};
constexpr Wrap kWraps[] = {Wrap::Repeat, Wrap::ClampToEdge, Wrap::MirroredRepeat};

/// A square that shows the picture so many times along each side, in the middle once.
Scene showing(const franken::Image& image, Filter filter, Wrap wrapS, Wrap wrapT, float copies = 3) {
    SceneBuilder builder;
    Material material;
    material.unlit = true;
    material.textures[TextureRole::BaseColor].texture = builder.addTexture(image, filter, wrapS);
    builder.scene.textures[0].wrapT = wrapT;
    builder.scene.textures[0].magFilter = filter == Filter::Nearest ? Filter::Nearest : Filter::Linear;
    Primitive primitive = square();
    for (glm::vec2& uv : primitive.uv[0])
        uv = 0.5f + copies * (uv - 0.5f);
    builder.add(std::move(primitive), builder.addMaterial(material));
    return builder.scene;
}

/// Neither half nor neighbour alike, and smooth at its own seams; of any size.
franken::Image waves(int width, int height) {
    franken::Image image{"waves", width, height, {}};
    const auto code = [](double wave) { return static_cast<std::uint8_t>(std::lround(120 + 100 * wave)); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double s = 6.283185307 * (x + 0.5) / width, t = 6.283185307 * (y + 0.5) / height;
            const std::uint8_t texel[] = {code(std::sin(s)), code(std::cos(t)), code(std::sin(s + t)), 255};
            image.rgba.insert(image.rgba.end(), std::begin(texel), std::end(texel));
        }
    return image;
}

TEST_P(CapabilitiesTest, PowersOfTwoNeedNothing) {
    for (const Filter filter : kFilters)
        for (const Wrap wrapS : kWraps)
            for (const Wrap wrapT : kWraps) {
                const Scene scene = showing(waves(32, 16), filter, wrapS, wrapT);
                EXPECT_EQ(compareLit(drawn(scene, kLeast), drawn(scene, kMost)).max(), 0)
                    << static_cast<int>(filter) << static_cast<int>(wrapS) << static_cast<int>(wrapT);
            }
}

TEST_P(CapabilitiesTest, OtherSizesAreKeptWhereGles2TakesThem) {
    for (const Filter filter : {Filter::Nearest, Filter::Linear}) {
        const Scene scene = showing(waves(33, 50), filter, Wrap::ClampToEdge, Wrap::ClampToEdge);
        EXPECT_EQ(compareLit(drawn(scene, kLeast), drawn(scene, kMost)).max(), 0);
    }
}

// Resampling moves what a texel shows by less than half of one, and the sizes have mip levels of other sizes.
// Measured, on waves that rise by up to 39 codes a pixel: mean up to 3.4 codes with linear filters, 6.7 with
// nearest ones; a picture that is off by half a texel, as with mipmaps that leave out a column, has 8.
TEST_P(CapabilitiesTest, OtherSizesAreResampledWhereItDoesNot) {
    for (const Filter filter : kFilters)
        for (const Wrap wrap : kWraps)
            for (const bool minified : {false, true}) {
                const bool kept =
                    wrap == Wrap::ClampToEdge && (filter == Filter::Nearest || filter == Filter::Linear);
                const Scene scene = minified ? showing(waves(33, 50), filter, wrap, wrap)
                                             : showing(waves(20, 27), filter, wrap, wrap, 1.5f);
                const Difference difference = compareLit(drawn(scene, kLeast), drawn(scene, kMost));
                const bool smooth = filter == Filter::Linear || filter == Filter::LinearMipmapLinear;
                const double limit = kept ? 0 : smooth ? 3.5 : 7;
                EXPECT_LE(difference.mean, limit)
                    << static_cast<int>(filter) << static_cast<int>(wrap) << minified << " " << difference;
                EXPECT_TRUE(m_messages.empty()) << "nobody need hear of it";
            }
}

TEST_P(CapabilitiesTest, WhatIsTooLargeIsScaledDownWithAWarning) {
    const Scene scene = showing(waves(256, 128), Filter::LinearMipmapLinear, Wrap::Repeat, Wrap::Repeat);
    const Picture full = drawn(scene, kMost);
    EXPECT_TRUE(m_messages.empty());
    const Difference difference = compareLit(drawn(scene, kLeast), full);
    EXPECT_LE(difference.mean, 2) << difference;
    ASSERT_EQ(m_messages.size(), 1u);
    EXPECT_EQ(m_messages[0].level, LogLevel::Warning);
    EXPECT_NE(m_messages[0].text.find("\"waves\" is scaled down to 64x32"), std::string::npos)
        << m_messages[0].text;
}

/// A strip of triangles without shared vertices.
Scene strip(std::size_t vertices) {
    SceneBuilder builder;
    Primitive primitive;
    for (std::size_t i = 0; i < vertices; ++i) {
        const float x = 2 * static_cast<float>(i / 3 * 3) / static_cast<float>(vertices) - 1;
        primitive.positions.emplace_back(x + (i % 3 == 1 ? 0.02f : 0), i % 3 == 2 ? 1 : -1, 0);
        primitive.indices.push_back(static_cast<std::uint32_t>(i));
        primitive.bounds.add(primitive.positions.back());
    }
    primitive.normals.assign(vertices, {0, 0, 1});
    Material material;
    material.unlit = true;
    material.doubleSided = true;
    builder.add(std::move(primitive), builder.addMaterial(material));
    return builder.scene;
}

TEST_P(CapabilitiesTest, MeshesAreSplitBeyond65535Vertices) {
    struct Row {
        std::size_t vertices;
        bool wide;
        std::size_t draws;
        GLenum type;
    };
    for (const Row& row : {Row{65'535, false, 1, GL_UNSIGNED_SHORT}, Row{65'535, true, 1, GL_UNSIGNED_SHORT},
                           Row{65'538, false, 2, GL_UNSIGNED_SHORT}, Row{65'538, true, 1, GL_UNSIGNED_INT}}) {
        Capabilities capabilities = kLeast;
        capabilities.wideIndices = row.wide;
        Renderer renderer(recordingGl(gl()), capabilities);
        ASSERT_TRUE(renderer.load(strip(row.vertices)));
        Camera camera;
        camera.world[3] = glm::vec4(0, 0, 3, 1);
        const DrawTarget target{.framebuffer = surface().framebuffer(), .width = 64, .height = 64};
        ASSERT_TRUE(renderer.draw(viewpointOf(camera, 1), target));
        recordedCalls().clear();
        ASSERT_TRUE(renderer.draw(viewpointOf(camera, 1), target));
        EXPECT_EQ(countCalls("DrawElements"), row.draws) << row.vertices;
        for (const GlCall& call : recordedCalls())
            if (call.name == "DrawElements") {
                EXPECT_EQ(call.arguments[2], row.type);
            }
    }
    const Scene scene = strip(200'001);
    Capabilities wide = kLeast;
    wide.wideIndices = true;
    EXPECT_EQ(compareLit(drawn(scene, kLeast), drawn(scene, wide)).max(), 0);
}

/// A grid of one triangle below it, whose corners are the last vertices: the only thing to be seen.
Scene lastTriangle(std::size_t vertices) {
    SceneBuilder builder;
    Primitive primitive;
    primitive.positions.assign(vertices, {-5, -5, -5});
    const glm::vec3 corners[] = {{-0.8f, -0.8f, 0}, {0.8f, -0.8f, 0}, {0, 0.8f, 0}};
    std::copy(std::begin(corners), std::end(corners), primitive.positions.end() - 3);
    primitive.normals.assign(vertices, {0, 0, 1});
    for (std::size_t i = vertices - 3; i < vertices; ++i)
        primitive.indices.push_back(static_cast<std::uint32_t>(i));
    for (const glm::vec3& position : primitive.positions)
        primitive.bounds.add(position);
    Material material;
    material.unlit = true;
    builder.add(std::move(primitive), builder.addMaterial(material));
    return builder.scene;
}

// The largest 16-bit index is kept free (some GPUs restart strips at it): 65,535 vertices are the most.
TEST_P(CapabilitiesTest, TheLastVerticesAreDrawnAroundTheLimitOf16Bits) {
    Capabilities wide = kLeast;
    wide.wideIndices = true;
    const Picture expected = drawn(lastTriangle(3), kLeast);
    EXPECT_GT(compareLit(expected, expected).pixels, 500u);
    for (const std::size_t vertices : {65'534, 65'535, 65'536, 65'537, 65'538})
        for (const Capabilities& capabilities : {kLeast, wide})
            EXPECT_EQ(compareLit(drawn(lastTriangle(vertices), capabilities), expected).max(), 0)
                << vertices << (capabilities.wideIndices ? " wide" : " narrow");
}

TEST_P(CapabilitiesTest, IndicesAreOf16BitsWhereTheyFitAndWhereOthersAreLacking) {
    struct Row {
        std::size_t vertices;
        bool wide;
        GLenum type;
    };
    for (const Row& row : {Row{65'535, true, GL_UNSIGNED_SHORT}, Row{65'536, true, GL_UNSIGNED_INT},
                           Row{65'537, true, GL_UNSIGNED_INT}, Row{65'535, false, GL_UNSIGNED_SHORT},
                           Row{65'536, false, GL_UNSIGNED_SHORT}, Row{65'537, false, GL_UNSIGNED_SHORT}}) {
        Capabilities capabilities = kLeast;
        capabilities.wideIndices = row.wide;
        Renderer renderer(recordingGl(gl()), capabilities);
        ASSERT_TRUE(renderer.load(lastTriangle(row.vertices)));
        recordedCalls().clear();
        Camera camera;
        camera.world[3] = glm::vec4(0, 0, 3, 1);
        ASSERT_TRUE(renderer.draw(viewpointOf(camera, 1),
                                  {.framebuffer = surface().framebuffer(), .width = 64, .height = 64}));
        const GlCall* last = nullptr; // The one before proves that the program draws.
        for (const GlCall& call : recordedCalls())
            last = call.name == "DrawElements" ? &call : last;
        ASSERT_NE(last, nullptr);
        EXPECT_EQ(last->arguments[2], row.type) << row.vertices;
    }
}

// Softpipe's fragments have 32 bits, whatever was drawn and set before.
TEST_P(CapabilitiesTest, PrecisionIsMeasuredWhateverGlWasLeftAt) {
    for (int turn = 0; turn < 4; ++turn) {
        gl().ClearColor(1, 1, 1, 1);
        gl().Clear(GL_COLOR_BUFFER_BIT);
        disturbState(gl());
        gl().Enable(GL_CULL_FACE);
        gl().CullFace(turn % 2 == 0 ? GL_FRONT : GL_BACK);
        gl().FrontFace(turn < 2 ? GL_CW : GL_CCW);
        EXPECT_EQ(Capabilities::query(gl()).precision, Precision::Fp32) << turn;
    }
}

/// What a driver says that it is.
struct Driver {
    const char *version, *extensions, *renderer;
};
Driver driver;

Capabilities capabilitiesOf(const Gl& gl, const Driver& said) {
    driver = said;
    Gl table = gl;
    table.GetString = [](GLenum name) {
        return reinterpret_cast<const GLubyte*>(name == GL_VERSION      ? driver.version
                                                : name == GL_EXTENSIONS ? driver.extensions
                                                                        : driver.renderer);
    };
    return Capabilities::query(table);
}

TEST_P(CapabilitiesTest, AreReadFromWhatTheDriverSays) {
    const char* const es2 = "OpenGL ES 2.0 Mesa 25.0.7";
    const Capabilities least = capabilitiesOf(gl(), {es2, "GL_OES_texture_npot_2 GL_EXT_other", "Mali-400"});
    EXPECT_FALSE(least.anyTextureSize || least.wideIndices || least.parallelCompile ||
                 least.compilesForStaleTextures);
    EXPECT_TRUE(capabilitiesOf(gl(), {es2, "GL_A GL_OES_texture_npot GL_B", "x"}).anyTextureSize);
    EXPECT_TRUE(capabilitiesOf(gl(), {es2, "GL_OES_element_index_uint", "x"}).wideIndices);
    EXPECT_TRUE(capabilitiesOf(gl(), {es2, "GL_A GL_KHR_parallel_shader_compile", "x"}).parallelCompile);
    for (const char* pi : {"VC4 V3D 2.1", "V3D 4.2.14"})
        EXPECT_TRUE(capabilitiesOf(gl(), {es2, "", pi}).compilesForStaleTextures) << pi;
    for (const char* core : {"OpenGL ES 3.1 Mesa 25.0.7", "4.5 (Compatibility Profile) Mesa 22.3.6"}) {
        const Capabilities more = capabilitiesOf(gl(), {core, "", "x"});
        EXPECT_TRUE(more.anyTextureSize && more.wideIndices) << core;
    }
}

} // namespace
} // namespace franken::test
