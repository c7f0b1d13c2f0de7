// SPDX-License-Identifier: MIT
#include "franken/environment.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "franken/file.h"
#include "image/exr.h"
#include "image/hdr.h"
#include "sky/hdre.h"
#include "sky/sky.h"

namespace franken {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kFaceNames{"px", "nx", "py", "ny", "pz", "nz"};

Error at(const fs::path& path, Error error) {
    error.where = path.string();
    return error;
}

/// One picture, which may take `room` bytes.
Result<FloatImage> decodePicture(std::span<const std::uint8_t> file, std::size_t room) {
    if (isHdre(file))
        return Error{"sky.shape", "", "an HDRE file holds all six faces, and cannot be one of them",
                     "give the file alone"};
    return isHdr(file)   ? decodeHdr(file, kMaxSkyWidth, room)
           : isExr(file) ? decodeExr(file, kMaxSkyWidth, room)
                         : decodeSrgbImage(file, kMaxSkyWidth, room);
}

/// One face, which may take `room` bytes while and after it is read.
Result<FloatImage> loadFace(const fs::path& path, std::size_t maxFileBytes, std::size_t room) {
    const auto bytes = readSkyFile(path, std::min(maxFileBytes, room));
    if (!bytes)
        return bytes.error();
    Result<FloatImage> picture = decodePicture(*bytes, room - bytes->size());
    return picture ? std::move(picture) : at(path, picture.error());
}

/// Appends the square of a cross to the faces of a cube.
void appendSquare(Environment& sky, const FloatImage& cross, int column, int row, bool upsideDown) {
    const int size = sky.width;
    for (int i = 0; i < size * size; ++i) {
        const int from = upsideDown ? size * size - 1 - i : i;
        const int x = column * size + from % size, y = row * size + from / size;
        sky.texels.push_back(
            cross.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(cross.width) +
                         static_cast<std::size_t>(x)]);
    }
    sky.height += size;
}

Environment fromCross(const FloatImage& cross) {
    const bool wide = cross.width > cross.height;
    Environment sky{Environment::Layout::Cube, wide ? cross.width / 4 : cross.width / 3, 0, {}};
    sky.texels.reserve(std::size_t{6} * sky.width * sky.width);
    appendSquare(sky, cross, 2, 1, false);
    appendSquare(sky, cross, 0, 1, false);
    appendSquare(sky, cross, 1, 0, false);
    appendSquare(sky, cross, 1, 2, false);
    appendSquare(sky, cross, 1, 1, false);
    wide ? appendSquare(sky, cross, 3, 1, false) : appendSquare(sky, cross, 1, 3, true);
    return sky;
}

Result<Environment> fromPicture(const fs::path& path, Result<FloatImage> picture, const SkyLimits& limits) {
    if (!picture)
        return at(path, picture.error());
    const int width = picture->width, height = picture->height;
    if (width == 2 * height)
        return Environment{Environment::Layout::Equirect, width, height, std::move(picture->texels)};
    if ((width % 4 == 0 && width / 4 * 3 == height) || (width % 3 == 0 && width / 3 * 4 == height)) {
        const std::size_t half = picture->texels.size() / 2; // six squares of twelve
        if (3 * half * sizeof(glm::vec3) > limits.maxMemoryBytes)
            return memoryError(path.string());
        return fromCross(*picture);
    }
    return Error{"sky.shape", path.string(),
                 "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " is not a sky",
                 "use 2:1 for an equirectangular sky, 4:3 or 3:4 for a cross, or a folder of six faces"};
}

Result<Environment> loadSingleFile(const fs::path& path, const SkyLimits& limits) {
    auto bytes = readSkyFile(path, std::min(limits.maxFileBytes, limits.maxMemoryBytes));
    if (!bytes)
        return bytes.error();
    const std::size_t room = limits.maxMemoryBytes - bytes->size();
    if (isHdre(*bytes)) {
        Result<Environment> sky = decodeHdre(*bytes, kMaxSkyWidth / 4, room);
        return sky ? std::move(sky) : at(path, sky.error());
    }
    Result<FloatImage> picture = decodePicture(*bytes, room);
    *bytes = {};
    return fromPicture(path, std::move(picture), limits);
}

/// Whether a file's name without its extension is that of the face, or ends in it after another word.
bool isFace(const fs::path& path, std::string_view face) {
    std::string stem = path.stem().string();
    std::transform(stem.begin(), stem.end(), stem.begin(), [](unsigned char c) { return std::tolower(c); });
    if (!stem.ends_with(face))
        return false;
    return stem.size() == 2 || !std::isalpha(static_cast<unsigned char>(stem[stem.size() - 3]));
}

Result<Environment> loadFolder(const fs::path& folder, const SkyLimits& limits) {
    std::array<fs::path, 6> faces;
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure))
        for (std::size_t face = 0; face < 6; ++face)
            if (isFace(entry->path(), kFaceNames[face])) {
                if (!faces[face].empty())
                    return Error{"sky.shape", folder.string(),
                                 "there is more than one face " + std::string(kFaceNames[face]),
                                 "keep one sky in a folder, or name its six files"};
                faces[face] = entry->path();
            }
    if (failure)
        return Error{"sky.file", folder.string(), "the folder cannot be read: " + failure.message(),
                     "check the path"};
    for (std::size_t face = 0; face < 6; ++face)
        if (faces[face].empty())
            return Error{"sky.shape", folder.string(), "there is no face " + std::string(kFaceNames[face]),
                         "name the six files px, nx, py, ny, pz and nz"};
    return loadEnvironment(faces, limits);
}

} // namespace

Result<std::vector<std::uint8_t>> readSkyFile(const fs::path& path, std::size_t maxBytes) {
    auto bytes = readFile(path, maxBytes);
    if (bytes)
        return bytes;
    return Error{"sky.file", path.string(), bytes.error().what,
                 bytes.error().code == "file.size" ? "make the file smaller, or raise the limits of SkyLimits"
                                                   : bytes.error().remedy};
}

Result<Environment> loadEnvironment(const fs::path& path, const SkyLimits& limits) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) ? loadFolder(path, limits) : loadSingleFile(path, limits);
}

Result<Environment> loadEnvironment(const std::array<fs::path, 6>& faces, const SkyLimits& limits) {
    Environment sky{Environment::Layout::Cube, 0, 0, {}};
    for (const fs::path& path : faces) {
        const std::size_t held = sky.texels.capacity() * sizeof(glm::vec3);
        const Result<FloatImage> face = loadFace(path, limits.maxFileBytes, limits.maxMemoryBytes - held);
        if (!face)
            return face.error();
        if (face->width != face->height || (sky.width != 0 && face->width != sky.width))
            return Error{"sky.shape", path.string(),
                         "the face is " + std::to_string(face->width) + " x " + std::to_string(face->height),
                         "all six faces must be square and of one size"};
        if (7 * face->texels.size() * sizeof(glm::vec3) > limits.maxMemoryBytes)
            return memoryError(path.string());
        sky.width = face->width;
        sky.height += face->height;
        sky.texels.reserve(6 * face->texels.size());
        sky.texels.insert(sky.texels.end(), face->texels.begin(), face->texels.end());
    }
    return sky;
}

} // namespace franken
