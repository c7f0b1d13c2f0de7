// SPDX-License-Identifier: MIT
// Our program of the seed page's permutation against the seed page's own program, on the same scene.
//
// The page takes the bitangent as cross(T, N), glTF as cross(N, T) * w: so w is -1 here. Its normals are
// right without translation alone: so there is none. Its ambient colour is given in gamma 2.2.
#include "franken/gl_object.h"
#include "support/draw_scene.h"
#include "support/shapes.h"
#include "support/shell.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace franken::test {
namespace {

constexpr int kSize = 256;
constexpr glm::vec3 kAmbientInGamma(0.3f, 0.35f, 0.4f);

Shot seedShot() {
    SceneBuilder builder;
    Material material;
    material.factors.baseColor = {0.9f, 0.8f, 0.7f, 1};
    material.factors.metallic = 0.3f;
    material.factors.roughness = 0.4f;
    material.textures[TextureRole::BaseColor].texture =
        builder.addTexture(checkers(64, 8, {0.9f, 0.5f, 0.2f, 1}, {0.2f, 0.5f, 0.9f, 1}), Filter::Linear);
    material.textures[TextureRole::Normal].texture = builder.addTexture(bumps(128, 8), Filter::Linear);
    Primitive ball = sphere(48);
    for (glm::vec4& tangent : ball.tangents)
        tangent.w = -1;
    builder.add(std::move(ball), builder.addMaterial(material));
    builder.addSun({-0.6f, -0.5f, -0.7f}, {1, 0.95f, 0.9f}, 3);

    Shot shot{.scene = builder.scene, .camera = {}, .lighting = lightingOf(builder.scene)};
    shot.camera.yfov = 0.6f;
    shot.camera.world[3] = {0, 0, 4, 1};
    shot.lighting.ambient.kind = Ambient::Color;
    for (int i = 0; i < 3; ++i)
        shot.lighting.ambient.color[static_cast<std::size_t>(i)] = std::pow(kAmbientInGamma[i], 2.2f);
    shot.look = {.brdf = Brdf::Seed, .decode = Decode::None, .output = Output::Linear};
    return shot;
}

class SeedTest : public PictureTest {
protected:
    SeedTest() : PictureTest({kSize, kSize}) {}

    Picture drawAsThePageDoes(const Shot& shot, const std::filesystem::path& folder);

private:
    GlProgram link(const std::filesystem::path& folder);
    GlTexture upload(const Picture& image, GLenum unit);
    void setUniforms(GLuint program, const Shot& shot);
};

INSTANTIATE_TEST_SUITE_P(Backends, SeedTest, allBackends(), backendName);

GlProgram SeedTest::link(const std::filesystem::path& folder) {
    GlProgram program(gl(), gl().CreateProgram());
    for (const auto& [type, file] :
         {std::pair(GL_VERTEX_SHADER, "seed_s1.vert"), std::pair(GL_FRAGMENT_SHADER, "seed_s1.frag")}) {
        const GlShader shader(gl(), gl().CreateShader(static_cast<GLenum>(type)));
        const std::string text = "#version 100\n" + readText(folder / file); // Desktop GL takes it for 1.10.
        const char* const source = text.c_str();
        gl().ShaderSource(shader.name(), 1, &source, nullptr);
        gl().CompileShader(shader.name());
        gl().AttachShader(program.name(), shader.name());
    }
    const char* const attributes[] = {"aPosition", "aNormal", "aTangent", "aUV0"};
    for (GLuint location = 0; location < std::size(attributes); ++location)
        gl().BindAttribLocation(program.name(), location, attributes[location]);
    gl().LinkProgram(program.name());
    GLint linked = GL_FALSE;
    gl().GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_TRUE);
    return program;
}

GlTexture SeedTest::upload(const Picture& image, GLenum unit) {
    GlTexture texture(gl(), generate(gl().GenTextures));
    gl().ActiveTexture(GL_TEXTURE0 + unit);
    gl().BindTexture(GL_TEXTURE_2D, texture.name());
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.rgba.data());
    return texture;
}

void SeedTest::setUniforms(GLuint program, const Shot& shot) {
    const auto location = [&](const char* name) { return gl().GetUniformLocation(program, name); };
    const auto set3 = [&](const char* name, const glm::vec3& v) {
        gl().Uniform3f(location(name), v.x, v.y, v.z);
    };
    const Material& material = shot.scene.materials[0];
    const Light& sun = shot.scene.lights[0];
    const Viewpoint viewpoint = viewpointOf(shot.camera, 1);
    const glm::mat4 identity(1), mvp(viewpoint.viewProjection);
    gl().UniformMatrix4fv(location("uMVP"), 1, GL_FALSE, glm::value_ptr(mvp));
    gl().UniformMatrix4fv(location("uLocalToWorld"), 1, GL_FALSE, glm::value_ptr(identity));
    gl().UniformMatrix4fv(location("uLocalToWorld_it"), 1, GL_FALSE, glm::value_ptr(identity));
    set3("uCameraPosWorld", viewpoint.eye);
    gl().Uniform4fv(location("uMaterialAlbedoColor"), 1, material.factors.baseColor.data());
    gl().Uniform1f(location("uMaterialRoughness"), material.factors.roughness);
    gl().Uniform1f(location("uMaterialMetallic"), material.factors.metallic);
    gl().Uniform1i(location("uTextureAlbedo"), 0);
    gl().Uniform1i(location("uTextureNormal"), 1);
    set3("uAmbientColor", kAmbientInGamma);
    set3("uLightRadiance0", sun.color * sun.intensity);
    set3("uLightDir0", sun.direction);
}

Picture SeedTest::drawAsThePageDoes(const Shot& shot, const std::filesystem::path& folder) {
    const GlProgram program = link(folder);
    gl().UseProgram(program.name());
    setUniforms(program.name(), shot);
    const GlTexture base = upload(shot.scene.images[0], 0), normal = upload(shot.scene.images[1], 1);
    const Primitive& ball = shot.scene.meshes[0].primitives[0];
    gl().BindBuffer(GL_ARRAY_BUFFER, 0);
    gl().BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    const auto attribute = [&](GLuint index, GLint size, GLsizei stride, const void* data) {
        gl().EnableVertexAttribArray(index);
        gl().VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, stride, data);
    };
    attribute(0, 3, sizeof(glm::vec3), ball.positions.data());
    attribute(1, 3, sizeof(glm::vec3), ball.normals.data());
    attribute(2, 3, sizeof(glm::vec4), ball.tangents.data());
    attribute(3, 2, sizeof(glm::vec2), ball.uv[0].data());
    const std::vector<std::uint16_t> indices(ball.indices.begin(), ball.indices.end());
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    return readBack();
}

TEST_P(SeedTest, DrawsTheSameImageAsTheSeedPage) {
    const std::filesystem::path folder = findShared("qpu/shaders");
    if (folder.empty())
        GTEST_SKIP() << "needs ../shared/qpu/shaders beside the sources";
    const Shot shot = seedShot();
    const auto needed = usesOf(shot.scene, shot.lighting, shot.look);
    ASSERT_TRUE(needed && needed->size() == 1);
    EXPECT_EQ(toName(needed->front().permutation), "basecolor.normal+ambient+sun1+seed+decode-none+linear");

    for (const Target target : kForms) {
        const Picture ours = draw(withForms(shot, target));
        const Picture theirs = drawAsThePageDoes(shot, folder); // With the state that ours has left.
        const Difference difference = compareLit(ours, theirs);
        std::cout << difference << "\n";
        EXPECT_GT(difference.pixels, 20'000u);
        EXPECT_LE(difference.max(), 1) << writeDifference("seed", ours, theirs);
    }
}

} // namespace
} // namespace franken::test
