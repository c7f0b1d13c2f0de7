// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"
#include "franken/light.h"
#include "franken/scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <vector>

namespace franken::bench {

/// What somebody would write who draws one kind of material and needs no library for it: a base colour
/// texture, a normal map, ambient light and one sun. It takes the same program as the renderer, makes the
/// same state changes in the same order, and knows everything else in advance: names, uniform locations,
/// vertex formats. Matrices are multiplied in float. Each object must be an instance of a mesh of one
/// primitive.
class HandLoop {
public:
    HandLoop(const Gl& gl, const Scene& scene, const Lighting& lighting);
    ~HandLoop();
    HandLoop(const HandLoop&) = delete;
    HandLoop& operator=(const HandLoop&) = delete;

    void draw(const glm::mat4& viewProjection, const glm::vec3& eye, GLuint framebuffer, int size);

private:
    struct Mesh {
        GLuint vertices, indices;
        GLsizei count;
    };
    struct Material {
        GLuint baseColorTexture, normalTexture;
        float normalScale;
        float baseColor[4], reflectance[4], lobe[3];
    };
    struct Object {
        std::size_t mesh, material;
        glm::mat4 model;
        glm::mat3 normal;
    };
    struct Locations {
        GLint modelViewProjection, model, normalMatrix, cameraPosition, normalScale, baseColor, reflectance,
            lobe, ambient, sunDirection, sunRadiance;
    };

    void makeProgram();
    void addMesh(const Primitive& primitive);
    void addMaterial(const Scene& scene, const franken::Material& material);
    GLuint makeTexture(const Scene& scene, int texture);
    void useMaterial(const Material& material);
    void useMesh(const Mesh& mesh);

    const Gl& m_gl;
    GLuint m_program = 0;
    Locations m_at{};
    std::vector<Mesh> m_meshes;
    std::vector<Material> m_materials;
    std::vector<Object> m_objects; ///< By material and mesh.
    float m_ambient[3], m_sunDirection[3], m_sunRadiance[3];
    bool m_begun = false;
};

} // namespace franken::bench
