// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace make_model {

/// Shapes to paint and engrave with, as signed distances in metres: negative inside, zero on the outline.
/// Points are in metres around the shape's centre, x to the right and y up. Beyond a sharp tip the values are
/// too small, which makes outlines of equal width end in a mitre.

/// A circle.
double disc(glm::dvec2 point, double radius);

/// Two arcs that meet in tips at (0, ±halfLength): a leaf, a petal. halfWidth ≤ halfLength.
double leaf(glm::dvec2 point, double halfWidth, double halfLength);

/// A pointed window: straight sides from y = 0 down to -`sill`, above them two arcs that meet at `rise`.
/// halfWidth ≤ rise.
double arch(glm::dvec2 point, double halfWidth, double rise, double sill);

/// Eight petals around the centre, with a point at distance `radius`, one of them straight up.
double rosette(glm::dvec2 point, double radius);

/// The line y = height · sin(2π x / length), with no width of its own; to first order.
double wave(glm::dvec2 point, double height, double length);

/// The point relative to the nearest centre of a row of shapes that repeat in x, every `pitch` metres.
/// Centres are at odd multiples of half the pitch, so that a row that starts at 0 starts with a whole shape.
glm::dvec2 repeat(glm::dvec2 point, double pitch);

/// How much of a texel of the given size a shape covers: 1 inside, 0 outside, a ramp of one texel between.
double cover(double distance, double texel);

/// The same for a line of the given width along the outline.
double stroke(double distance, double width, double texel);

/// A smooth swelling for reliefs: 1 from `depth` inside the outline inwards, 0 outside.
double swell(double distance, double depth);

/// The same as half a ball, for beads and stones: 1 in the middle of a circle, 0 from its edge outwards.
double dome(glm::dvec2 point, double radius);

/// Whether a point is on the line of a Greek key. One unit of the border is 1 wide and repeats in x; y runs
/// from 0 (top) to 1 over its height. x ≥ 0, and outside of the height there is no line.
bool greekKey(glm::dvec2 point);

/// Hammered metal: the squared distance, in cells, to the nearest of the points that lie one to a cell at
/// random: round dents with ridges between. Repeats in x after `period` cells.
double dents(glm::dvec2 point, int period, unsigned seed);

} // namespace make_model
