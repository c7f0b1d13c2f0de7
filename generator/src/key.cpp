// SPDX-License-Identifier: MIT
#include "franken/generator/choices.h"

#include <cassert>

namespace franken {
namespace {

constexpr unsigned kVersionShift = 60;

constexpr Key mask(unsigned shift, unsigned bits) { return ((Key{1} << bits) - 1) << shift; }

Error badKey(std::string what) {
    return {"permutation.key", "", std::move(what), "pass a key that toKey() of this version returned"};
}

} // namespace

Key toKey(const Permutation& permutation) {
    Key key = Key{kSchemaVersion} << kVersionShift;
    for (const Choice& choice : choices()) {
        const unsigned value = choice.get(permutation);
        assert(value < choice.options.size());
        key |= Key{value} << choice.shift;
    }
    return key;
}

Result<Permutation> fromKey(Key key) {
    if (const auto version = key >> kVersionShift; version != kSchemaVersion)
        return Error{"permutation.schema", "", "the key has schema version " + std::to_string(version),
                     "this library reads version " + std::to_string(kSchemaVersion) + "; name it anew"};
    for (const ReservedBits& reserved : reservedBits())
        if (key & mask(reserved.shift, reserved.bits))
            return badKey("the bits reserved for " + std::string(reserved.name) + " are set");
    Permutation permutation;
    for (const Choice& choice : choices()) {
        const auto value = static_cast<unsigned>((key & mask(choice.shift, choice.bits)) >> choice.shift);
        if (value >= choice.options.size())
            return badKey(std::string(choice.name) + " has no value " + std::to_string(value));
        choice.set(permutation, value);
    }
    return permutation;
}

} // namespace franken
