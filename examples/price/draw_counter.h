// SPDX-License-Identifier: MIT
#pragma once

#include "frame_counts.h"

namespace price {

/// Whether points in clip space lie wholly outside of one of the six planes of the view.
bool isBesideTheView(std::span<const glm::dvec4> places);

/// Counts the draws of a frame, one after the other.
class DrawCounter {
public:
    /// The frame must outlive it.
    explicit DrawCounter(const FrameContents& frame) : m_frame(frame), m_raster(frame.width, frame.height) {
        m_counts.width = frame.width;
        m_counts.height = frame.height;
    }

    /// Faces of the mesh as the file has it; an instance that is mirrored turns them round. Nothing is
    /// counted of what lies wholly beside the view, which is not drawn.
    void add(const franken::Instance& instance, const franken::Primitive& primitive,
             const franken::MaterialPlan& plan, Faces faces);

    /// Where there is one.
    void addSkybox();

    FrameCounts take() { return std::move(m_counts); }

private:
    const FrameContents& m_frame;
    Raster m_raster;
    FrameCounts m_counts;
};

} // namespace price
