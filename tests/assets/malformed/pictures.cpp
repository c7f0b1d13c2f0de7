// SPDX-License-Identifier: MIT
#include "malformed/pictures.h"

#include <algorithm>

namespace pictures {
namespace {

void appendBigEndian(std::string& out, std::uint32_t value, int bytes) {
    while (bytes-- > 0)
        out += static_cast<char>(value >> 8 * bytes);
}

// ISO/IEC 15948, annex D, bit by bit.
std::uint32_t crc(const std::string& data) {
    std::uint32_t remainder = 0xFFFFFFFF;
    for (const char c : data) {
        remainder ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            remainder = remainder >> 1 ^ (remainder & 1 ? 0xEDB88320u : 0u);
    }
    return ~remainder;
}

/// Bits into bytes, the lowest bit of each byte first (RFC 1951, 3.1.1).
class BitWriter {
public:
    explicit BitWriter(std::string& out) : m_out(out) {}
    ~BitWriter() {
        if (m_used > 0)
            m_out += static_cast<char>(m_byte);
    }
    /// The highest of `count` bits first, as Huffman codes are.
    void code(unsigned bits, int count) {
        while (count-- > 0) {
            m_byte |= (bits >> count & 1) << m_used;
            if (++m_used == 8) {
                m_out += static_cast<char>(m_byte);
                m_byte = 0, m_used = 0;
            }
        }
    }

private:
    std::string& m_out;
    unsigned m_byte = 0;
    int m_used = 0;
};

std::string segment(int marker, const std::string& data) {
    std::string out = "\xFF";
    out += static_cast<char>(marker);
    appendBigEndian(out, static_cast<std::uint32_t>(data.size() + 2), 2);
    return out + data;
}

struct HuffmanCode {
    std::size_t bits; ///< 1 to 16
    int symbol;
};

/// The shortest codes first. `kind`: 0x00 for DC, 0x10 for AC.
std::string huffmanTable(int kind, std::initializer_list<HuffmanCode> codes) {
    std::string data(17, '\0');
    data[0] = static_cast<char>(kind);
    for (const HuffmanCode& code : codes) {
        ++data[code.bits];
        data += static_cast<char>(code.symbol);
    }
    return segment(0xC4, data);
}

constexpr int kBaseline = 0xC0, kProgressive = 0xC2;

/// A grey JPEG up to its frame.
std::string jpegHead(int frameMarker, int width, int height) {
    std::string frame{8};
    appendBigEndian(frame, static_cast<std::uint32_t>(height), 2);
    appendBigEndian(frame, static_cast<std::uint32_t>(width), 2);
    frame += {1, 1, 0x11, 0};
    return "\xFF\xD8" + segment(0xDB, '\0' + std::string(64, '\1')) + segment(frameMarker, frame);
}

const char kJpegEnd[] = "\xFF\xD9";

std::string scan(int first, int last, const std::string& bits) {
    const std::string header{1, 1, 0, static_cast<char>(first), static_cast<char>(last), 0};
    return segment(0xDA, header) + bits;
}

} // namespace

const char kPngMagic[9] = "\x89PNG\r\n\x1A\n";

std::string pngChunk(const std::string& name, const std::string& data) {
    std::string out;
    appendBigEndian(out, static_cast<std::uint32_t>(data.size()), 4);
    out += name + data;
    appendBigEndian(out, crc(name + data), 4);
    return out;
}

std::string pngHeader(std::uint32_t width, std::uint32_t height, int depth, int type) {
    std::string data;
    appendBigEndian(data, width, 4);
    appendBigEndian(data, height, 4);
    data += {static_cast<char>(depth), static_cast<char>(type), 0, 0, 0};
    return pngChunk("IHDR", data);
}

// RFC 1951, 3.2.6: literal 0 is 00110000, a match of 258 is 11000101, distance 1 is 00000.
std::string deflatedZeros(std::size_t count) {
    std::string out = "\x78\x9C";
    {
        BitWriter bits(out);
        bits.code(1, 1);
        bits.code(2, 2); // 01, lowest bit first
        for (std::size_t done = 0; done < count;) {
            const bool match = done > 0 && count - done >= 258;
            match ? bits.code(0b1100010100000, 13) : bits.code(0b00110000, 8);
            done += match ? 258 : 1;
        }
        bits.code(0, 7);
    }
    appendBigEndian(out, static_cast<std::uint32_t>(count % 65521) << 16 | 1, 4); // RFC 1950's checksum
    return out;
}

std::string png(std::uint32_t width, std::uint32_t height, int depth, int type) {
    const std::size_t channels = type == 2 ? 3 : type == 4 ? 2 : type == 6 ? 4 : 1;
    const std::size_t row = 1 + (channels * static_cast<std::size_t>(depth) * width + 7) / 8;
    return kPngMagic + pngHeader(width, height, depth, type) +
           (type == 3 ? pngChunk("PLTE", std::string(3, '\0')) : "") +
           pngChunk("IDAT", deflatedZeros(row * height)) + pngChunk("IEND", "");
}

std::string jpeg(int width, int height, bool progressive, int scans) {
    std::string out = jpegHead(progressive ? kProgressive : kBaseline, width, height) +
                      huffmanTable(0x00, {{1, 0}}) + huffmanTable(0x10, {{1, 0}});
    const std::size_t blocks =
        (static_cast<std::size_t>(width) + 7) / 8 * ((static_cast<std::size_t>(height) + 7) / 8);
    if (!progressive)
        return out + scan(0, 63, std::string(blocks / 4 + 1, '\0')) + kJpegEnd;
    const std::string bits(blocks / 8 + 1, '\0');
    out += scan(0, 0, bits);
    for (int i = 1; i < scans; ++i)
        out += scan(1, 63, bits);
    return out + kJpegEnd;
}

// The first block takes 1 bit and 15, the second 9 bits and 15, of which 7 are there.
std::string jpegOfLongValues() {
    const std::string bits("\x00\x00\x80\x00", 4);
    return jpegHead(kProgressive, 32, 8) + huffmanTable(0x00, {{1, 15}, {9, 15}}) + scan(0, 0, bits) +
           kJpegEnd;
}

std::string hdrRow(int width) {
    std::string row{2, 2, static_cast<char>(width >> 8), static_cast<char>(width)};
    for (const int value : {128, 128, 128, 129})
        for (int left = width; left > 0; left -= 127)
            row += {static_cast<char>(128 + std::min(left, 127)), static_cast<char>(value)};
    return row;
}

std::string hdr(int width, int height, int rows) {
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                      std::to_string(width) + "\n";
    const std::string row = hdrRow(width);
    for (int y = 0; y < rows; ++y)
        out += row;
    return out;
}

} // namespace pictures
