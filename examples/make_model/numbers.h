// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

/// The program that writes the demonstration model.
///
/// Tests compare pictures of the model with stored ones, so its bytes must be the same on every machine.
/// IEEE 754 fixes + - * / sqrt and floor to the last bit, but sin, cos and pow differ from one C library to
/// the next. All of this program therefore computes in doubles, from those six operations and what stands
/// in this header, and is compiled with -ffp-contract=off.
namespace make_model {

/// Sine and cosine of an angle in turns (1 = 360°), so that whole and half turns are hit exactly and the
/// first and last column of a closed surface coincide. Taylor series on a quarter turn; error below 1e-12.
double sinTurns(double turns);
double cosTurns(double turns);

/// A number in [0, 1) that looks random and depends on nothing but the lattice point and the seed. The mixing
/// constants are those of MurmurHash3's 32-bit finaliser.
double hash(int x, int y, unsigned seed);

/// Smooth noise in [0, 1] over the plane; one feature per unit. Repeats in x after `period` units (≥ 1).
double noise(glm::dvec2 point, int period, unsigned seed);

/// Four octaves of noise(), each of half the size and half the weight; in [0, 1].
double cloud(glm::dvec2 point, int period, unsigned seed);

/// 0 where x ≤ low, 1 where x ≥ high, with flat ends between; low < high.
double ramp(double low, double high, double x);

} // namespace make_model
