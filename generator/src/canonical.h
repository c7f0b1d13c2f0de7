// SPDX-License-Identifier: MIT
#pragma once

#include "franken/generator/permutation.h"

namespace franken {

/// A canonical permutation without the choices that the vertex shader alone reads.
Permutation fragmentChoices(const Permutation& permutation);

/// Whether a texture reads that stream of coordinates.
bool anyReads(const Permutation& permutation, UvStream stream);

/// Whether a texture is there whose coordinates this choice picks the stream of; roles may share a choice.
bool isRead(const Permutation& permutation, UvStream Permutation::*stream);

} // namespace franken
