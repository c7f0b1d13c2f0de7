// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

// What of a glTF file is read.
namespace franken::gltf {

enum class Kind {
    Boolean,
    String,
    Number,
    Integer,    ///< Of 32 bits.
    Natural,    ///< Likewise, and not negative.
    Size,       ///< An unsigned integer of 64 bits: bytes or elements.
    Index,      ///< A Natural that points into an array.
    Attributes, ///< An object whose every value is an Index.
    Object,
    Name, ///< A string for people: a number will do.
};

struct Property;
using Schema = std::span<const Property>;
inline constexpr std::size_t kOne = 0, kMany = std::numeric_limits<std::size_t>::max();

/// A member of an object.
struct Property {
    std::string_view name;
    Kind kind;
    std::size_t length = kOne; ///< One value, or an array: of so many, or of any number.
    Schema members{};          ///< Of Kind::Object.
    bool required = false;
    std::string_view empty{}; ///< What stands in for a faulty element of this array; none: it is refused.
};

/// A whole file's.
extern const Schema kFileSchema;

/// Whether something of the extension is read, or it needs no reading.
bool isKnown(std::string_view extension);

/// Whether a picture of the file at rest can do without it, even where the file says that it requires it.
bool isHarmless(std::string_view extension);

} // namespace franken::gltf
