// SPDX-License-Identifier: MIT
#include "malformed/malformed.h"
#include "malformed/pictures.h"

namespace {

using namespace pictures;

/// soundModel() with this image in its buffer, where it is used by all of the material's textures.
MalformedFile model(const std::string& name, const std::string& image, const std::string& code = "") {
    GltfBuilder file = soundModel();
    file.json["images"][0] = {{"mimeType", "image/png"},
                              {"bufferView", file.view(std::vector<char>(image.begin(), image.end()))}};
    return {"image/" + name, "glb", file.bytes(true), code};
}

std::string replaced(std::string bytes, std::size_t offset, const std::string& by) {
    return bytes.replace(offset, by.size(), by);
}

std::string hdrHeader(const std::string& lines) { return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines; }

std::vector<MalformedFile> pngs() {
    const std::string sound = png(16, 16, 8, 6), end = pngChunk("IEND", "");
    const auto chunks = [&](const std::string& middle) {
        return kPngMagic + pngHeader(16, 16) + middle + end;
    };
    return {
        model("png-empty", ""),
        model("png-magic-only", kPngMagic),
        model("png-header-cut", sound.substr(0, 20)),
        model("png-cut-in-half", sound.substr(0, sound.size() / 2)),
        model("png-without-pixels", chunks("")),
        model("png-without-end", sound.substr(0, sound.size() - end.size())),
        model("png-first-chunk-no-header", kPngMagic + end),
        model("png-header-twice",
              kPngMagic + pngHeader(16, 16) + pngHeader(16, 16) + pngChunk("IDAT", deflatedZeros(272)) + end),
        model("png-0-wide", png(0, 16)),
        model("png-2-to-the-31-wide",
              kPngMagic + pngHeader(0x80000000u, 1) + pngChunk("IDAT", deflatedZeros(99)) + end),
        model("png-8193-high", png(1, 8193)),
        model("png-claims-8192-x-8192",
              kPngMagic + pngHeader(8192, 8192, 16, 6) + pngChunk("IDAT", deflatedZeros(99)) + end),
        model("png-100000-x-100000",
              kPngMagic + pngHeader(100000, 100000) + pngChunk("IDAT", deflatedZeros(99)) + end),
        model("png-depth-3", kPngMagic + pngHeader(16, 16, 3) + pngChunk("IDAT", deflatedZeros(999)) + end),
        model("png-type-9", kPngMagic + pngHeader(16, 16, 8, 9) + pngChunk("IDAT", deflatedZeros(999)) + end),
        model("png-first-data-chunk-empty",
              chunks(pngChunk("IDAT", "") + pngChunk("IDAT", deflatedZeros(272)))),
        model("png-cut-in-an-empty-data-chunk",
              kPngMagic + pngHeader(16, 16) + std::string("\0\0\0\0IDAT", 8)),
        model("png-palette-missing",
              kPngMagic + pngHeader(16, 16, 8, 3) + pngChunk("IDAT", deflatedZeros(272)) + end),
        model("png-palette-too-long", kPngMagic + pngHeader(16, 16, 8, 3) +
                                          pngChunk("PLTE", std::string(999, 'x')) +
                                          pngChunk("IDAT", deflatedZeros(272)) + end),
        model("png-chunk-of-all-ones", replaced(sound, 33, "\xFF\xFF\xFF\xFF")),
        model("png-too-few-pixels", chunks(pngChunk("IDAT", deflatedZeros(100)))),
        model("png-a-million-pixels-too-many", chunks(pngChunk("IDAT", deflatedZeros(1000000)))),
        model("png-1-x-1-inflates-to-400-MiB",
              kPngMagic + pngHeader(1, 1) + pngChunk("IDAT", deflatedZeros(std::size_t{400} << 20)) + end),
        model("png-stream-without-end", chunks(pngChunk("IDAT", deflatedZeros(272).substr(0, 4)))),
        model("png-stream-of-noise", chunks(pngChunk("IDAT", "\x78\x9C\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF"))),
        model("png-filter-9",
              chunks(pngChunk("IDAT", "\x78\x01\x01\x10\x01\xEF\xFE" + std::string(272, '\x09')))),
        model("png-distance-before-the-start",
              chunks(pngChunk("IDAT", std::string("\x78\x9C\x03\x02\x00\x00", 6)))),
        model("png-transparency-before-palette", kPngMagic + pngHeader(16, 16, 8, 3) +
                                                     pngChunk("tRNS", "xxxx") +
                                                     pngChunk("IDAT", deflatedZeros(272)) + end),
        model("png-iphone-chunk-first", kPngMagic + pngChunk("CgBI", "xxxx") + pngHeader(16, 16) +
                                            pngChunk("IDAT", deflatedZeros(272)) + end),
    };
}

/// Cut off a byte into the data of a scan, counted from 1.
std::string cutInScan(const std::string& jpeg, int number) {
    std::size_t scan = 0;
    for (int i = 0; i < number; ++i)
        scan = jpeg.find("\xFF\xDA", scan + 1);
    return jpeg.substr(0, scan + 12);
}

std::vector<MalformedFile> jpegs() {
    const std::string sound = jpeg(64, 64);
    const std::size_t frame = sound.find("\xFF\xC0"), scan = sound.find("\xFF\xDA");
    const std::string head = sound.substr(0, frame), rest = sound.substr(frame);
    const auto beforeScan = [&](const std::string& segment) {
        return sound.substr(0, scan) + segment + sound.substr(scan);
    };
    return {
        model("jpeg-magic-only", "\xFF\xD8\xFF"),
        model("jpeg-without-frame", head + "\xFF\xD9"),
        model("jpeg-frame-cut", sound.substr(0, frame + 6)),
        model("jpeg-cut-before-its-scan", sound.substr(0, scan)),
        model("jpeg-cut-in-its-scan", sound.substr(0, scan + 12)),
        model("jpeg-cut-before-its-end", sound.substr(0, sound.size() - 2)),
        model("jpeg-cut-in-its-second-scan", cutInScan(jpeg(64, 64, true, 3), 2)),
        model("jpeg-unknown-marker-after-its-frame", beforeScan(std::string("\xFF\xF0\x00\x02", 4))),
        model("jpeg-quantiser-9-after-its-frame",
              beforeScan(std::string("\xFF\xDB\x00\x43\x09", 5) + std::string(64, '\1'))),
        model("jpeg-huffman-codes-too-many-after-its-frame",
              beforeScan(std::string("\xFF\xC4\x00\x17\x00\x04", 6) + std::string(15, '\0') + "abcd")),
        model("jpeg-restarts-of-three-bytes", beforeScan(std::string("\xFF\xDD\x00\x05\0\0\0", 7))),
        model("jpeg-0-wide", replaced(sound, frame + 7, std::string(2, '\0'))),
        model("jpeg-0-high", replaced(sound, frame + 5, std::string(2, '\0'))),
        model("jpeg-65535-x-65535", replaced(sound, frame + 5, "\xFF\xFF\xFF\xFF")),
        model("jpeg-claims-8192-x-8192", replaced(sound, frame + 5, std::string("\x20\x00\x20\x00", 4))),
        model("jpeg-12-bits", replaced(sound, frame + 4, "\x0C")),
        model("jpeg-255-components", replaced(sound, frame + 9, "\xFF")),
        model("jpeg-sampling-0", replaced(sound, frame + 11, std::string(1, '\0'))),
        model("jpeg-quantiser-9", replaced(sound, frame + 12, "\x09")),
        model("jpeg-lossless", replaced(sound, frame + 1, "\xC3")),
        model("jpeg-segment-length-0", head + std::string("\xFF\xDB\x00\x00", 4) + rest),
        model("jpeg-segment-past-the-end", head + "\xFF\xDB\xFF\xFF" + rest),
        model("jpeg-huffman-codes-too-many",
              head + std::string("\xFF\xC4\x00\x13\x00\xFF", 6) + std::string(15, '\xFF') + rest),
        model("jpeg-huffman-codes-too-many-in-a-cut-segment",
              sound.substr(0, scan) + std::string("\xFF\xC4\x20\x00\x00", 5) + std::string(16, '\xFF')),
        model("jpeg-huffman-tables-missing", sound.substr(0, sound.find("\xFF\xC4")) + sound.substr(scan)),
        model("jpeg-huffman-table-cut-in-its-counts",
              head + std::string("\xFF\xC4\x00\x04\x00\xFF", 6) + rest),
        model("jpeg-huffman-second-table-too-long", head + std::string("\xFF\xC4\x00\x25\x00\x01", 6) +
                                                        std::string(16, '\0') + std::string(1, '\x10') +
                                                        std::string(16, '\xFF') + rest),
        model("jpeg-bits-end-inside-a-value", jpegOfLongValues()),
        model("jpeg-two-frames", head + sound.substr(frame, 13) + rest),
        model("jpeg-of-101-scans", jpeg(64, 64, true, 101)),
        model("jpeg-of-100000-scans", jpeg(2048, 2048, true, 100000 / 256)),
        model("jpeg-of-100-scans", jpeg(1024, 1024, true, 100)),
        model("gif", "GIF89a" + std::string(100, '\1')),
        model("bmp", "BM" + std::string(100, '\1')),
        model("webp", "RIFF\x20\1\1\1WEBPVP8 " + std::string(100, '\1')),
        model("ktx", "\xABKTX 20\xBB\r\n\x1A\n" + std::string(100, '\1')),
        model("text", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"),
    };
}

} // namespace

std::vector<MalformedFile> malformedImages() {
    std::vector<MalformedFile> all = pngs();
    for (MalformedFile& file : jpegs())
        all.push_back(std::move(file));
    return all;
}

std::vector<MalformedFile> malformedSkies() {
    const char* const kFormat = "hdr.format";
    const std::string sound = hdr(64, 32, 32);
    const std::size_t row = sound.size() - 32 * hdrRow(64).size();
    return {
        {"sky/empty", "hdr", "", "image.format"},
        {"sky/magic-only", "hdr", "#?", kFormat},
        {"sky/no-size", "hdr", hdrHeader(""), kFormat},
        {"sky/header-without-end", "hdr", hdrHeader(std::string(1000, 'x')), kFormat},
        {"sky/a-million-header-lines", "hdr", hdrHeader([] {
             std::string lines;
             for (int i = 0; i < 1000000; ++i)
                 lines += "x\n";
             return lines;
         }()),
         kFormat},
        {"sky/format-xyze", "hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n", kFormat},
        {"sky/size-0", "hdr", hdrHeader("\n-Y 0 +X 0\n"), "hdr.size"},
        {"sky/size-negative", "hdr", hdrHeader("\n-Y -32 +X -64\n"), "hdr.size"},
        {"sky/size-beyond-ints", "hdr", hdrHeader("\n-Y 99999999999 +X 1\n"), kFormat},
        {"sky/size-beyond-the-limit", "hdr", hdrHeader("\n-Y 8193 +X 8193\n"), "hdr.size"},
        {"sky/size-no-number", "hdr", hdrHeader("\n-Y x +X y\n"), kFormat},
        {"sky/size-with-more-behind", "hdr", hdrHeader("\n-Y 1 +X 2 +Z 3\n"), kFormat},
        {"sky/rows-from-bottom-to-top", "hdr", hdrHeader("\n+Y 1 +X 2\n"), kFormat},
        {"sky/no-texels", "hdr", hdr(64, 32, 0), kFormat},
        {"sky/cut-in-a-row", "hdr", sound.substr(0, sound.size() - 5), kFormat},
        {"sky/last-row-missing", "hdr", hdr(64, 32, 31), kFormat},
        {"sky/claims-8192-x-4096", "hdr", hdr(8192, 4096, 1), kFormat},
        {"sky/holds-8192-x-4096", "hdr", hdr(8192, 4096, 4096), "sky.limit"},
        {"sky/run-past-its-row", "hdr", replaced(sound, row + 4, "\xFF"), kFormat},
        {"sky/run-of-nothing", "hdr", replaced(sound, row + 4, std::string(1, '\0')), kFormat},
        {"sky/stretch-past-the-end", "hdr", hdr(64, 32, 31) + std::string("\2\2\0\x40\x40", 5), kFormat},
        {"sky/row-of-another-width", "hdr", replaced(sound, row + 3, "\x41"), kFormat},
        {"sky/brightest-exponents", "hdr", hdrHeader("\n-Y 1 +X 2\n") + std::string(8, '\xFF'), ""},
        {"sky/bytes-behind-the-end", "hdr", sound + "behind", ""},
        {"sky/square", "hdr", hdr(64, 64, 64), "sky.shape"},
        {"sky/one-texel", "hdr", hdrHeader("\n-Y 1 +X 1\n") + std::string(4, '\x80'), "sky.shape"},
        {"sky/gif", "gif", "GIF89a" + std::string(100, '\1'), "image.format"},
        {"sky/png-cut", "png", png(64, 32).substr(0, 60), "image.format"},
        {"sky/png-claims-8192-x-4096", "png",
         kPngMagic + pngHeader(8192, 4096) + pngChunk("IDAT", deflatedZeros(99)), "image.format"},
        {"sky/png-holds-8192-x-4096", "png", png(8192, 4096), "sky.limit"},
        {"sky/jpeg-holds-8192-x-4096", "jpg", jpeg(8192, 4096), "sky.limit"},
        {"sky/jpeg-of-101-scans", "jpg", jpeg(64, 32, true, 101), "image.format"},
    };
}
