// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// OpenEXR pictures for the tests, written by tinyexr.
namespace franken::test {

struct ExrFile {
    int width = 62, height = 31;
    int compression = 0; ///< As the file's attribute has it: 0 none, 1 RLE, 2 ZIPS, 3 ZIP, 4 PIZ.
    bool half = true;    ///< In the file; otherwise floats.
    std::vector<std::string> channels{"A", "B", "G", "R"}; ///< Sorted.
    int tile = 0; ///< The size of tiles, which must divide width and height; 0 for lines.
};

/// What channel number `channel` of an ExrFile holds at that texel; exact as a half.
float exrValue(std::size_t channel, int x, int y);

std::string exrBytes(const ExrFile& file);

/// The bytes with that attribute's value replaced from its first byte on. The attribute must be there.
std::string withAttribute(std::string bytes, const std::string& name, const std::string& value);

/// A little-endian 32-bit number.
std::string int32(int value);

/// The picture of lines with its stored texels moved: their window, and the chunks' coordinates.
std::string movedData(std::string bytes, const ExrFile& file, int x, int y);

} // namespace franken::test
