// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

/// Pictures that are small in a file and as large as the test likes in memory, and their parts, so that a
/// test can put a wrong one in. All are sound unless a parameter makes them lie.
namespace pictures {

/// A PNG chunk with its length and checksum.
std::string pngChunk(const std::string& name, const std::string& data);
/// The header chunk. `type`: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA.
std::string pngHeader(std::uint32_t width, std::uint32_t height, int depth = 8, int type = 0);
/// `count` zeros as a zlib stream, packed 158 to 1.
std::string deflatedZeros(std::size_t count);
/// A black PNG.
std::string png(std::uint32_t width, std::uint32_t height, int depth = 8, int type = 0);
extern const char kPngMagic[9];

/// A grey JPEG in which each block of 8 x 8 takes two bits. A progressive one has the given number of scans.
std::string jpeg(int width, int height, bool progressive = false, int scans = 1);

/// A grey JPEG whose one scan ends inside the 15 bits of the second block's value.
std::string jpegOfLongValues();

/// A Radiance picture of `rows` rows, run-length encoded, whose header claims `width` x `height`.
std::string hdr(int width, int height, int rows);
/// One run-length encoded row of texels of radiance 1.
std::string hdrRow(int width);

} // namespace pictures
