// SPDX-License-Identifier: MIT
#pragma once

#include "gpu_mesh.h"

#include <array>
#include <cstring>

namespace franken {

/// The joints of a vertex, as attributes hold them; those of weight 0 move nothing.
struct JointInfluences {
    std::array<float, Permutation::kMaxInfluences> joints{}, weights{};
};

inline JointInfluences influencesAt(const VertexFormat& format, const std::uint8_t* vertex) {
    JointInfluences influences;
    std::memcpy(influences.joints.data(), vertex + format.joints, sizeof(influences.joints));
    std::memcpy(influences.weights.data(), vertex + format.weights, sizeof(influences.weights));
    return influences;
}

inline void store(const JointInfluences& influences, const VertexFormat& format, std::uint8_t* vertex) {
    std::memcpy(vertex + format.joints, influences.joints.data(), sizeof(influences.joints));
    std::memcpy(vertex + format.weights, influences.weights.data(), sizeof(influences.weights));
}

} // namespace franken
