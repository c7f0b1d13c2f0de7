// SPDX-License-Identifier: MIT
#pragma once

#include "franken/gl.h"
#include "franken/result.h"
#include "price/frame_bill.h"

#include <functional>
#include <string>

/// What frames took on the GPU of a context.
struct Measured {
    std::string renderer;    ///< GL_RENDERER
    double milliseconds = 0; ///< The median of a frame, finished.
    double least = 0;        ///< Of all frames.
    int frames = 0;
};

/// Draws some frames, waits for each to be finished and times it. The first ones are not counted: a GPU that
/// was idle takes a while to raise its clock. Fails as `draw` does, and with "viewer.measure" where software
/// draws, whose times say nothing of a Raspberry Pi.
franken::Result<Measured> timeFrames(const franken::Gl& gl,
                                     const std::function<franken::Result<void>()>& draw);

/// Whether software draws, going by GL_RENDERER.
bool isSoftware(std::string_view renderer);

/// Some lines: measured beside predicted, in a form that can be sent in.
std::string comparisonOf(const Measured& measured, const price::FrameBill& predicted);
