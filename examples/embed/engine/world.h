// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

// What the engine shows, in its own words: nothing here knows of GL or of FrankenShader.

struct Vertex {
    glm::vec3 position, normal;
    glm::vec4 tangent; ///< w: the bitangent's side.
    glm::vec2 uv;      ///< v grows downwards.
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> triangles;
};

/// A square picture: RGBA, 8 bits a channel.
struct Bitmap {
    int size = 0;
    std::vector<std::uint8_t> texels;
};

struct Paint {
    glm::vec3 color{1}; ///< Linear; multiplies the picture.
    float metallic = 0, roughness = 1;
    bool textured = false; ///< By the world's two pictures.
};

struct Thing {
    Mesh mesh;
    Paint paint;
    glm::mat4 place{1};
};

struct World {
    std::vector<Thing> things;
    Bitmap tiles;  ///< Colours, sRGB.
    Bitmap ridges; ///< A normal map.

    glm::vec3 eye{0, 1.5f, 3.6f}, lookAt{0, 0, 0}; ///< m
    float yfov = 0.7f;                             ///< Radians.
    float near = 0.5f, far = 20;                   ///< m

    glm::vec3 sunDirection{-0.5f, -1, -0.4f}; ///< Where its light travels.
    float sunLux = 2.5f;
    glm::vec3 lampPosition{1.4f, 0.9f, 0.9f}; ///< m
    glm::vec3 lampColor{1, 0.6f, 0.3f};
    float lampCandela = 4;
    glm::vec3 ambient{0.10f, 0.12f, 0.15f}; ///< Radiance.
};

World makeWorld();

/// Turns the ring and moves the lamp to where they are at that time.
void animate(World& world, float seconds);
