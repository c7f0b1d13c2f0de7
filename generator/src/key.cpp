// SPDX-License-Identifier: MIT
#include "franken/generator/choices.h"

#include "effect_rules.h"

#include <algorithm>
#include <cassert>
#include <charconv>

namespace franken {
namespace {

Error badKey(std::string what) {
    return {"permutation.key", "", std::move(what), "pass a key that toKey() of this version returned"};
}

constexpr std::size_t kDigits = 16; // Of one word.

std::string_view lastDigits(std::string_view digits) {
    return digits.substr(digits.size() - std::min(digits.size(), kDigits));
}

bool readWord(std::string_view digits, std::uint64_t& word) {
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), word, 16);
    return failed == std::errc() && end == digits.data() + digits.size();
}

/// Packs, and returns the first choice that has no such value, if there is one.
const Choice* pack(const Permutation& permutation, Key& key) {
    key = keyBits(kSchemaVersion, kSchemaBits.shift);
    const auto add = [&key](std::uint64_t value, unsigned shift) {
        key.words[shift / 64] |= value << shift % 64;
    };
    add(permutation.effect.slot, kEffectBits.shift);
    for (const Choice& choice : choices()) {
        const unsigned value = choice.get(permutation);
        if (value >= choice.options.size())
            return &choice;
        add(value, choice.shift);
    }
    return nullptr;
}

} // namespace

Key toKey(const Permutation& permutation) {
    Key key;
    [[maybe_unused]] const Choice* const wrong = pack(permutation, key);
    assert(wrong == nullptr && isEffect(permutation.effect));
    return key;
}

Result<Key> checkedKey(const Permutation& permutation) {
    Key key;
    if (!isEffect(permutation.effect))
        return noEffect(toName(permutation));
    if (const Choice* const wrong = pack(permutation, key); wrong != nullptr)
        return Error{"permutation.range", toName(permutation),
                     std::string(wrong->name) + " has no value " + std::to_string(wrong->get(permutation)),
                     "pass what canonicalise() returned"};
    return key;
}

Result<Permutation> fromKey(const Key& key, const SnippetSet& snippets) {
    if (const auto version = valueOf(key, kSchemaBits.shift, kSchemaBits.bits); version != kSchemaVersion)
        return Error{"permutation.schema", "", "the key has schema version " + std::to_string(version),
                     "this library reads version " + std::to_string(kSchemaVersion) + "; name it anew"};
    for (const ReservedBits& reserved : reservedBits())
        if (valueOf(key, reserved.shift, reserved.bits) != 0)
            return badKey("the bits reserved for " + std::string(reserved.name) + " are set");
    Permutation permutation;
    for (const Choice& choice : choices()) {
        const auto value = static_cast<unsigned>(valueOf(key, choice.shift, choice.bits));
        if (value >= choice.options.size())
            return badKey(std::string(choice.name) + " has no value " + std::to_string(value));
        choice.set(permutation, value);
    }
    const auto slot = static_cast<std::size_t>(valueOf(key, kEffectBits.shift, kEffectBits.bits));
    if (slot > snippets.effects().size())
        return missingEffect("in slot " + std::to_string(slot));
    if (slot > 0)
        permutation.effect = snippets.effects()[slot - 1].choice(static_cast<std::uint8_t>(slot));
    return permutation;
}

std::string toHex(const Key& key) {
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string text = "0x";
    for (const std::uint64_t word : {key.words[1], key.words[0]})
        for (int shift = 60; shift >= 0; shift -= 4)
            text += kHex[word >> shift & 15U];
    return text;
}

Result<Key> parseHex(std::string_view hex) {
    const std::string_view digits = hex.substr(hex.starts_with("0x") ? 2 : 0);
    const std::string_view low = lastDigits(digits);
    const std::string_view high = digits.substr(0, digits.size() - low.size());
    Key key;
    if (high.size() > kDigits || !readWord(low, key.words[0]) ||
        (!high.empty() && !readWord(high, key.words[1])))
        return Error{"permutation.key", std::string(hex), "this is not a key",
                     "copy a key from 'frankenshader list --json'"};
    return key;
}

} // namespace franken
