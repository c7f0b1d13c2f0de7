// SPDX-License-Identifier: MIT
#include "sweep.h"

#include "lathe.h"
#include "numbers.h"

namespace make_model {
namespace {

void appendRing(Mesh& mesh, const Bend& bend, double t, int around) {
    const glm::dvec2 slope = bend.path.slope(t);
    const glm::dvec2 curving = bend.path.bend(t);
    const double speed = glm::length(slope);
    const glm::dvec2 forward = slope / speed;
    const glm::dvec3 sideways(-forward.y, forward.x, 0.0);
    const glm::dvec3 centre(bend.path.at(t), 0.0);
    const double radius = glm::mix(bend.radiusFrom, bend.radiusTo, t);
    const double taper = bend.radiusTo - bend.radiusFrom;
    const double turning = (slope.x * curving.y - slope.y * curving.x) / (speed * speed);

    for (int i = 0; i <= around; ++i) {
        const double turns = double(i) / around;
        const glm::dvec3 outward = cosTurns(turns) * sideways - glm::dvec3(0.0, 0.0, sinTurns(turns));
        const double advance = speed - radius * cosTurns(turns) * turning;
        const glm::dvec3 normal = advance * outward - taper * glm::dvec3(forward, 0.0);
        mesh.positions.push_back(snap(centre + radius * outward));
        mesh.normals.emplace_back(glm::normalize(normal));
    }
}

} // namespace

Mesh sweep(const std::vector<Bend>& bends, int around) {
    Mesh mesh;
    for (const Bend& bend : bends) {
        const std::size_t first = mesh.positions.size();
        for (int ring = 0; ring <= bend.rings; ++ring)
            appendRing(mesh, bend, double(ring) / bend.rings, around);
        appendGrid(mesh, first, bend.rings, around);
    }
    return mesh;
}

} // namespace make_model
