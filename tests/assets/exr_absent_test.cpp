// SPDX-License-Identifier: MIT
// A build without tinyexr says so; its other skies are read as ever.
#include <gtest/gtest.h>

#include "image/exr.h"

TEST(Exr, AbsentIsSaid) {
    const auto image = franken::decodeExr({}, 1, 1);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, "exr.absent");
    EXPECT_NE(image.error().remedy.find("libtinyexr-dev"), std::string::npos);
}
