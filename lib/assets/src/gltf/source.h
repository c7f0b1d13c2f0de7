// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "franken/gltf.h"
#include "franken/scene.h"

namespace franken::gltf {

inline constexpr std::string_view kDamaged = "the file is cut or damaged: copy or export it again";
inline constexpr std::string_view kFixExporter =
    "export the file again, or see what glTF-Validator says of it";

/// A buffer of the file. Its bytes are looked for, but their absence is an error only where they are drawn.
struct Buffer {
    std::string uri; ///< Empty: the binary chunk, or none at all.
    bool hasUri = false;
    std::size_t length = 0;              ///< As declared; the bytes may be none.
    std::span<const std::uint8_t> bytes; ///< Exactly `length`, or empty.
    std::vector<std::uint8_t> storage;   ///< What `bytes` points into, unless that is Source::bytes.
    std::string problem;                 ///< Why there are no bytes.
};

/// An image of the file, still as PNG or JPEG.
struct EncodedImage {
    std::string name;
    std::string uri;
    int view = kNone;                ///< The buffer view that holds it, where it has no URI.
    std::vector<std::uint8_t> bytes; ///< Where it has one.
    std::string problem;             ///< Why there are no bytes.
};

// Codes of warnings; gltf.h says what they mean.
inline constexpr std::string_view kMended = "gltf.mended";
inline constexpr std::string_view kUnneeded = "gltf.unneeded";
inline constexpr std::string_view kLeftOut = "gltf.left-out";

// How much is done when each part has ended, by the time that they take of usual files.
inline constexpr float kReadFile = 0.05f, kReadJson = 0.1f, kReadImages = 0.7f;

/// A file being loaded, and where complaints about it go. Functions that can fail return false after a call
/// of fail(); the first error stays.
struct Source {
    std::string file;
    LoadOptions options;
    Log log;
    std::span<const std::uint8_t> bytes;       ///< The file.
    std::span<const std::uint8_t> jsonText;    ///< In `bytes`.
    std::span<const std::uint8_t> binaryChunk; ///< In `bytes`; empty in a .gltf.
    std::vector<Buffer> buffers;
    std::vector<EncodedImage> images;
    std::vector<std::filesystem::path> files; ///< Scene::files
    std::vector<std::size_t> strides;         ///< By buffer view, as the file has them; 0: packed.
    std::size_t charged = 0;                  ///< Bytes, of LoadOptions::maxMemoryBytes.
    std::optional<Error> error;
    /// By element ("/cameras/1"): what is wrong with it, if it is needed.
    std::map<std::string, Error> faults;
    std::set<std::string> warned;

    /// Records an error at the JSON path `where`; false, to be returned.
    bool fail(std::string_view code, const std::string& where, std::string what,
              std::string_view remedy = kFixExporter);
    /// Takes the error back where it is a fault of `element` alone, which may be one that nothing needs: then
    /// it is noted as that, and the answer is true. What could endanger memory (sizes, ranges, cycles) stays.
    bool defer(const std::string& element);
    /// Raises the element's fault, if it has one; false then.
    bool need(const std::string& element);
    /// Warns of the faults that nothing needed.
    void warnOfUnneeded() const;

    /// Says how much is done, and what comes now. False with an error where loading is cancelled.
    bool proceed(float done, std::string_view what);

    /// Takes `count` times `bytesEach` from the memory that the file may use, for `where`, before it is
    /// allocated. Nothing is ever given back: so it bounds the work as well. Fails where loading is
    /// cancelled, too: whatever takes long allocates.
    bool charge(std::size_t count, std::size_t bytesEach, const std::string& where);
    /// What is left of it.
    std::size_t room() const { return options.maxMemoryBytes - charged; }

    /// Logs a warning at the JSON path `where`.
    void warn(std::string_view code, const std::string& where, const std::string& what) const;
    /// Logs a warning whose text was not there before.
    void warnOnce(std::string_view code, const std::string& what);
};

/// "/meshes/0/primitives/1" from ("meshes", 0, "primitives", 1).
template<typename... Parts>
std::string pathOf(const Parts&... parts) {
    std::string path;
    const auto add = [&path](const auto& part) {
        path += '/';
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>)
            path += std::to_string(part);
        else
            path += part;
    };
    (add(parts), ...);
    return path;
}

inline std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// False with an error unless `index` is -1 (absent) or below `size`.
bool checkIndex(Source& source, int index, std::size_t size, const std::string& where);
/// False with an error unless `index` is below `size`.
bool checkPresent(Source& source, int index, std::size_t size, const std::string& where);
/// False with an error unless all numbers are finite as floats.
bool checkFinite(Source& source, const std::vector<double>& numbers, const std::string& where);

} // namespace franken::gltf
