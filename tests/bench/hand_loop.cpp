// SPDX-License-Identifier: MIT
#include "hand_loop.h"

#include "franken/generator/compose.h"
#include "franken/generator/pack.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>
#include <tuple>

namespace franken::bench {
namespace {

struct Vertex {
    glm::vec3 position, normal;
    glm::vec4 tangent;
    glm::vec2 uv;
};

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

template<typename From, std::size_t count>
void copy(const From& from, float (&to)[count]) {
    std::copy_n(from.begin(), count, to);
}

GLuint compileShader(const Gl& gl, GLenum stage, const std::string& text) {
    const GLuint shader = gl.CreateShader(stage);
    const char* const source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    return shader;
}

} // namespace

HandLoop::HandLoop(const Gl& gl, const Scene& scene, const Lighting& lighting) : m_gl(gl) {
    makeProgram();
    for (const franken::Mesh& mesh : scene.meshes)
        addMesh(mesh.primitives.front());
    for (const franken::Material& material : scene.materials)
        addMaterial(scene, material);
    for (const Instance& instance : scene.instances) {
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        const auto material = static_cast<std::size_t>(scene.meshes[mesh].primitives.front().material);
        m_objects.push_back(
            {mesh, material, instance.world, glm::transpose(glm::inverse(glm::mat3(instance.world)))});
    }
    std::stable_sort(m_objects.begin(), m_objects.end(), [](const Object& a, const Object& b) {
        return std::tie(a.material, a.mesh) < std::tie(b.material, b.mesh);
    });
    const LightsBlock lights = packLighting(lighting, {});
    copy(lights.ambient.color, m_ambient);
    copy(lights.sunDirection[0], m_sunDirection);
    copy(lights.sunRadiance[0], m_sunRadiance);
}

HandLoop::~HandLoop() {
    for (const Mesh& mesh : m_meshes) {
        m_gl.DeleteBuffers(1, &mesh.vertices);
        m_gl.DeleteBuffers(1, &mesh.indices);
    }
    for (const Material& material : m_materials) {
        m_gl.DeleteTextures(1, &material.baseColorTexture);
        m_gl.DeleteTextures(1, &material.normalTexture);
    }
    m_gl.DeleteProgram(m_program);
}

void HandLoop::makeProgram() {
    const Composed text = compose(canonicalise(*parseName("basecolor.normal+ambient+sun1"))->permutation);
    m_program = m_gl.CreateProgram();
    const GLuint vertex = compileShader(m_gl, GL_VERTEX_SHADER, text.vertex.text);
    const GLuint fragment = compileShader(m_gl, GL_FRAGMENT_SHADER, text.fragment.text);
    m_gl.AttachShader(m_program, vertex);
    m_gl.AttachShader(m_program, fragment);
    constexpr const char* kAttributes[] = {"aPosition", "aNormal", "aTangent", "aUv0"};
    for (GLuint location = 0; location < 4; ++location)
        m_gl.BindAttribLocation(m_program, location, kAttributes[location]);
    m_gl.LinkProgram(m_program);
    m_gl.DeleteShader(vertex);
    m_gl.DeleteShader(fragment);
    const auto find = [&](const char* name) { return m_gl.GetUniformLocation(m_program, name); };
    m_at = {find("uModelViewProjection"), find("uModel"),       find("uNormalMatrix"),
            find("uCameraPosition"),      find("uNormalScale"), find("uBaseColor"),
            find("uReflectance"),         find("uLobe"),        find("uAmbient"),
            find("uSun0Direction"),       find("uSun0Radiance")};
    m_gl.UseProgram(m_program);
    m_gl.Uniform1i(find("uBaseColorTexture"), 0);
    m_gl.Uniform1i(find("uNormalTexture"), 1);
}

void HandLoop::addMesh(const Primitive& primitive) {
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < primitive.positions.size(); ++i)
        vertices.push_back(
            {primitive.positions[i], primitive.normals[i], primitive.tangents[i], primitive.uv[0][i]});
    const std::vector<std::uint16_t> indices(primitive.indices.begin(), primitive.indices.end());
    Mesh mesh{0, 0, static_cast<GLsizei>(indices.size())};
    m_gl.GenBuffers(1, &mesh.vertices);
    m_gl.GenBuffers(1, &mesh.indices);
    m_gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
    m_gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                    vertices.data(), GL_STATIC_DRAW);
    m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
    m_gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * 2), indices.data(),
                    GL_STATIC_DRAW);
    m_meshes.push_back(mesh);
}

GLuint HandLoop::makeTexture(const Scene& scene, int texture) {
    const Image& image =
        scene.images[static_cast<std::size_t>(scene.textures[static_cast<std::size_t>(texture)].image)];
    GLuint name = 0;
    m_gl.GenTextures(1, &name);
    m_gl.BindTexture(GL_TEXTURE_2D, name);
    m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.rgba.data());
    m_gl.GenerateMipmap(GL_TEXTURE_2D);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return name;
}

void HandLoop::addMaterial(const Scene& scene, const franken::Material& material) {
    Material made{};
    made.baseColorTexture = makeTexture(scene, material.textures[TextureRole::BaseColor].texture);
    made.normalTexture = makeTexture(scene, material.textures[TextureRole::Normal].texture);
    const MaterialBlock block = packMaterial(material.factors, Brdf::Gltf, 1);
    made.normalScale = block.normalScale;
    copy(block.baseColor, made.baseColor);
    copy(block.reflectance, made.reflectance);
    copy(block.lobe, made.lobe);
    m_materials.push_back(made);
}

void HandLoop::useMaterial(const Material& material) {
    m_gl.ActiveTexture(GL_TEXTURE0);
    m_gl.BindTexture(GL_TEXTURE_2D, material.baseColorTexture);
    m_gl.ActiveTexture(GL_TEXTURE1);
    m_gl.BindTexture(GL_TEXTURE_2D, material.normalTexture);
    m_gl.Uniform1fv(m_at.normalScale, 1, &material.normalScale);
    m_gl.Uniform4fv(m_at.baseColor, 1, material.baseColor);
    m_gl.Uniform4fv(m_at.reflectance, 1, material.reflectance);
    m_gl.Uniform3fv(m_at.lobe, 1, material.lobe);
}

void HandLoop::useMesh(const Mesh& mesh) {
    constexpr GLsizei kStride = sizeof(Vertex);
    m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
    m_gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
    m_gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(Vertex, position)));
    m_gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(Vertex, normal)));
    m_gl.VertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, kStride, at(offsetof(Vertex, tangent)));
    m_gl.VertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(Vertex, uv)));
}

void HandLoop::draw(const glm::mat4& viewProjection, const glm::vec3& eye, GLuint framebuffer, int size) {
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_gl.Viewport(0, 0, size, size);
    if (!m_begun) {
        m_begun = true;
        m_gl.UseProgram(m_program);
        m_gl.Enable(GL_DEPTH_TEST);
        m_gl.DepthFunc(GL_LEQUAL);
        m_gl.Enable(GL_CULL_FACE);
        m_gl.Disable(GL_DITHER);
        m_gl.ClearColor(0, 0, 0, 1);
        for (GLuint location = 0; location < 4; ++location)
            m_gl.EnableVertexAttribArray(location);
        constexpr float kOrigin[3] = {0, 0, 0}; // Models are placed from the eye.
        m_gl.Uniform3fv(m_at.cameraPosition, 1, kOrigin);
        m_gl.Uniform3fv(m_at.ambient, 1, m_ambient);
        m_gl.Uniform3fv(m_at.sunDirection, 1, m_sunDirection);
        m_gl.Uniform3fv(m_at.sunRadiance, 1, m_sunRadiance);
    }
    m_gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    std::size_t material = m_materials.size(), mesh = m_meshes.size();
    for (const Object& object : m_objects) {
        if (object.material != material)
            useMaterial(m_materials[material = object.material]);
        if (object.mesh != mesh)
            useMesh(m_meshes[mesh = object.mesh]);
        const glm::mat4 modelViewProjection = viewProjection * object.model;
        m_gl.UniformMatrix4fv(m_at.modelViewProjection, 1, GL_FALSE, glm::value_ptr(modelViewProjection));
        m_gl.UniformMatrix3fv(m_at.normalMatrix, 1, GL_FALSE, glm::value_ptr(object.normal));
        glm::mat4 model = object.model;
        model[3] -= glm::vec4(eye, 0);
        m_gl.UniformMatrix4fv(m_at.model, 1, GL_FALSE, glm::value_ptr(model));
        m_gl.DrawElements(GL_TRIANGLES, m_meshes[mesh].count, GL_UNSIGNED_SHORT, nullptr);
    }
}

} // namespace franken::bench
