// SPDX-License-Identifier: MIT
#pragma once

#include "support/draw_scene.h"

#include <vector>

namespace franken::test {

/// One golden picture.
struct PictureRow {
    const char* name; ///< Of the file, without .png.
    Shot (*make)();
};

/// Every feature that a picture can show, as few at a time as possible; made here, from nothing.
std::vector<PictureRow> pictureRows();

} // namespace franken::test
