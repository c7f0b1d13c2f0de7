// SPDX-License-Identifier: MIT
#include "sheet.h"

#include <algorithm>
#include <cmath>

#include "lathe.h"

namespace make_model {
namespace {

// Where one side of a quad has no length, as at a petal's tip, the surface just before says where it faces.
glm::dvec3 normalOf(const Shape& shape, double u, double v) {
    constexpr double kStep = 1.0 / 1024.0;
    const double inner = std::clamp(v, 4.0 * kStep, 1.0 - 4.0 * kStep);
    const glm::dvec3 across = shape(u + kStep, inner) - shape(u - kStep, inner);
    const glm::dvec3 along = shape(u, inner + kStep) - shape(u, inner - kStep);
    return glm::normalize(glm::cross(along, across));
}

template<typename Function>
void eachPoint(int rows, int columns, Function function) {
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            function(double(column) / columns, double(row) / rows);
}

} // namespace

void appendSheet(Mesh& mesh, const Shape& shape, int rows, int columns,
                 const std::function<Held(double u, double v)>& held) {
    const std::size_t first = mesh.positions.size();
    eachPoint(rows, columns, [&](double u, double v) {
        mesh.positions.push_back(snap(shape(u, v)));
        mesh.normals.emplace_back(normalOf(shape, u, v));
        const Held point = held(u, v);
        mesh.colours.push_back(point.colour);
        mesh.joints.push_back(point.joints);
        mesh.weights.push_back(point.weights);
    });
    appendGrid(mesh, first, rows, columns);
}

void appendChange(Target& target, const Shape& from, const Shape& to, int rows, int columns) {
    eachPoint(rows, columns, [&](double u, double v) {
        target.positions.push_back(snap(to(u, v)) - snap(from(u, v)));
        target.normals.emplace_back(normalOf(to, u, v) - normalOf(from, u, v));
    });
}

glm::u8vec4 paint(glm::dvec3 linear) { return {toByte(linear.x), toByte(linear.y), toByte(linear.z), 255}; }

Held heldBy(int joint, glm::dvec3 colour) {
    return {paint(colour), {static_cast<std::uint8_t>(joint), 0, 0, 0}, {255, 0, 0, 0}};
}

Held heldBy(int first, int second, double share, glm::dvec3 colour) {
    const std::uint8_t part = toByte(share);
    return {paint(colour),
            {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second), 0, 0},
            {static_cast<std::uint8_t>(255 - part), part, 0, 0}};
}

} // namespace make_model
