// SPDX-License-Identifier: MIT
#include "mounts.h"

#include "lathe.h"
#include "numbers.h"
#include "profile.h"
#include "sweep.h"

namespace make_model {
namespace {

// Multiplied with the gold of the material: 1 = untouched.
glm::u8vec4 wear(double polish) {
    const glm::dvec3 colour = glm::mix(glm::dvec3(0.20, 0.13, 0.09), glm::dvec3(1.0), polish);
    return {toByte(colour.x), toByte(colour.y), toByte(colour.z), 255};
}

Profile mountsProfile() {
    return Profile({
        // Finial: bud, ring, and a disc that rests on the lid.
        {{{{{0.000, 1.690}, {0.012, 1.620}, {0.165, 1.555}, {0.022, 1.530}}}}, 12, {}},
        {{{{{0.022, 1.530}, {0.040, 1.528}, {0.040, 1.512}, {0.022, 1.510}}}}, 4, {}},
        {{{{{0.022, 1.510}, {0.024, 1.498}, {0.060, 1.502}, {0.064, 1.474}}}}, 5, {}},
        // Rim of the lid.
        {{{{{0.250, 1.352}, {0.305, 1.356}, {0.305, 1.308}, {0.250, 1.312}}}}, 7, {}},
        {{{{{0.262, 1.318}, {0.262, 1.300}, {0.235, 1.296}, {0.205, 1.296}}}}, 4, {}},
        // Collar of the neck: a large ring and a small one.
        {{{{{0.205, 1.158}, {0.228, 1.158}, {0.228, 1.142}, {0.212, 1.142}}}}, 4, {}},
        {{{{{0.212, 1.142}, {0.256, 1.144}, {0.256, 1.104}, {0.218, 1.106}}}}, 6, {}},
        // Knot between cup and foot.
        {{{{{0.098, 0.232}, {0.128, 0.232}, {0.128, 0.212}, {0.108, 0.212}}}}, 4, {}},
        {{{{{0.108, 0.212}, {0.162, 0.214}, {0.162, 0.160}, {0.100, 0.162}}}}, 7, {}},
        {{{{{0.084, 0.162}, {0.072, 0.140}, {0.074, 0.118}, {0.094, 0.104}}}}, 5, {}},
        // Foot: a bell, a step, and the ring it stands on.
        {{{{{0.094, 0.104}, {0.130, 0.086}, {0.225, 0.092}, {0.238, 0.052}}}}, 7, {}},
        {{{{{0.238, 0.052}, {0.254, 0.052}, {0.258, 0.048}, {0.258, 0.040}}}}, 2, {}},
        {{{{{0.258, 0.040}, {0.300, 0.042}, {0.300, 0.002}, {0.268, 0.000}}}}, 6, {}},
    });
}

} // namespace

Mesh turnMounts() {
    const Profile profile = mountsProfile();
    Mesh mesh = turn(profile, {.sectors = 1, .segments = 56});
    for (const glm::vec2& uv : mesh.uvs) {
        const double t = profile.find(uv.y).t;
        mesh.colours.push_back(wear(ramp(0.0, 0.5, 2.2 * t * (1.0 - t))));
    }
    mesh.tangents.clear();
    mesh.uvs.clear();
    return mesh;
}

Mesh bendHandle() {
    Mesh mesh = sweep(
        {
            {{{{{0.360, 0.980}, {0.420, 1.120}, {0.545, 1.200}, {0.640, 1.150}}}}, 0.022, 0.027, 12},
            {{{{{0.640, 1.150}, {0.735, 1.100}, {0.740, 0.960}, {0.690, 0.850}}}}, 0.027, 0.030, 12},
            {{{{{0.690, 0.850}, {0.640, 0.740}, {0.540, 0.720}, {0.535, 0.630}}}}, 0.030, 0.020, 12},
            {{{{{0.535, 0.630}, {0.530, 0.540}, {0.640, 0.530}, {0.640, 0.600}}}}, 0.020, 0.013, 12},
            {{{{{0.640, 0.600}, {0.640, 0.640}, {0.595, 0.640}, {0.595, 0.605}}}}, 0.013, 0.000, 8},
            // The thumb rest: a tendril that leaves the bow at its top.
            {{{{{0.560, 1.165}, {0.640, 1.170}, {0.700, 1.240}, {0.660, 1.285}}}}, 0.020, 0.012, 12},
            {{{{{0.660, 1.285}, {0.630, 1.315}, {0.595, 1.285}, {0.615, 1.255}}}}, 0.012, 0.000, 8},
        },
        12);
    for (const glm::vec3& normal : mesh.normals)
        mesh.colours.push_back(wear(ramp(-1.3, 0.4, normal.y))); // Dust settles, and rain washes, from above.
    return mesh;
}

} // namespace make_model
