// SPDX-License-Identifier: MIT
// Names, keys and canonical forms, one at a time; population_test.cpp asks the same of thousands.
#include "franken/generator/choices.h"
#include "franken/generator/permutation.h"

#include <gtest/gtest.h>

#include <set>

namespace franken {
namespace {

struct BadName {
    std::string_view name, code, where, remedy;
};

constexpr BadName kBadNames[] = {
    {"", "permutation.unknown-word", "column 1", ""},
    {"basecolor+nromal", "permutation.unknown-word", "column 11", "did you mean 'normal'?"},
    {"basecolour", "permutation.unknown-word", "column 1", "did you mean 'basecolor'?"},
    {"sun2+puntcual1", "permutation.unknown-word", "column 6", "did you mean 'punctual1'?"},
    {"basecolor..normal", "permutation.unknown-word", "column 11", ""},
    {"basecolor+", "permutation.unknown-word", "column 11", ""},
    {"+basecolor", "permutation.unknown-word", "column 1", ""},
    {"Basecolor", "permutation.unknown-word", "column 1", "did you mean 'basecolor'?"},
    {"basecolor normal", "permutation.unknown-word", "column 1", ""},
    {"sun1+sun2", "permutation.twice", "column 6", "keep one of the two words"},
    {"sun1+sun1", "permutation.twice", "column 6", "keep one of the two words"},
    {"normal+normal-vertex", "permutation.twice", "column 8", "keep one of the two words"},
};

TEST(Name, RefusesWhatIsNoName) {
    for (const BadName& row : kBadNames) {
        const auto parsed = parseName(row.name);
        ASSERT_FALSE(parsed) << row.name;
        EXPECT_EQ(parsed.error().code, row.code) << row.name;
        EXPECT_EQ(parsed.error().where, row.where) << row.name;
        if (!row.remedy.empty()) {
            EXPECT_EQ(parsed.error().remedy, row.remedy) << row.name;
        }
    }
}

TEST(Name, PointsAtTheWrongWord) {
    const auto parsed = parseName("basecolor+nromal+sun1");
    ASSERT_FALSE(parsed);
    EXPECT_NE(parsed.error().what.find("\n  basecolor+nromal+sun1\n            ^^^^^^"), std::string::npos)
        << parsed.error().what;
}

TEST(Name, LeavesDefaultsOut) {
    EXPECT_EQ(toName({}), "surface");
    Permutation p;
    p.baseColorTexture = true;
    p.normal = Normal::Map;
    p.ambient = Ambient::Color;
    p.suns = 2;
    EXPECT_EQ(toName(p), "basecolor.normal+ambient+sun2");
}

TEST(Name, TakesWordsInAnyOrderAndDefaultsSpeltOut) {
    const auto parsed = parseName("sun2.srgb+normal+surface+basecolor.ambient");
    ASSERT_TRUE(parsed) << toString(parsed.error());
    EXPECT_EQ(toName(*parsed), "basecolor.normal+ambient+sun2");
}

TEST(Name, WordsAreUnique) {
    std::set<std::string_view> words;
    for (const Choice& choice : choices())
        for (const Option& option : choice.options)
            EXPECT_TRUE(words.insert(option.word).second) << option.word;
}

Key with(Key key, std::uint64_t value, unsigned shift) {
    key.words[shift / 64] |= value << shift % 64;
    return key;
}

TEST(Key, BitsDoNotOverlap) {
    std::array<std::uint64_t, 2> used{};
    const auto take = [&](std::string_view name, unsigned shift, unsigned bits) {
        const std::uint64_t mask = ((std::uint64_t{1} << bits) - 1) << shift % 64;
        EXPECT_EQ(used[shift / 64] & mask, 0u) << name;
        EXPECT_LE(shift % 64 + bits, 64u) << name << " lies over both words";
        used[shift / 64] |= mask;
    };
    take(kSchemaBits.name, kSchemaBits.shift, kSchemaBits.bits);
    take(kEffectBits.name, kEffectBits.shift, kEffectBits.bits);
    for (const Choice& choice : choices()) {
        take(choice.name, choice.shift, choice.bits);
        EXPECT_LE(choice.options.size(), std::size_t{1} << choice.bits) << choice.name;
    }
    for (const ReservedBits& reserved : reservedBits())
        take(reserved.name, reserved.shift, reserved.bits);
    for (const std::uint64_t word : used)
        EXPECT_EQ(word, ~std::uint64_t{0}) << "every bit is a choice's, reserved or the version's";
}

TEST(Key, HasRoomForWhatIsComing) {
    unsigned spare = 0;
    for (const ReservedBits& reserved : reservedBits())
        spare += reserved.name.starts_with("spare") ? reserved.bits : 0;
    EXPECT_GE(spare, 12u);
    for (const Choice& choice : choices())
        if (const std::string_view name = choice.name; name == "toneMap" || name == "brdf" ||
                                                       name == "output" || name == "reflection" ||
                                                       name == "alpha") {
            EXPECT_LT(choice.options.size(), std::size_t{1} << choice.bits) << name << " is full";
        }
}

TEST(Key, ComesBackFromItsHex) {
    for (const char* name :
         {"surface", "basecolor+sun1", "sky+aces", "basecolor.normal+sh+reflection+sun4+vc4"}) {
        const Key key = toKey(*parseName(name));
        const std::string hex = toHex(key);
        EXPECT_EQ(hex.size(), 34u);
        const auto read = parseHex(hex);
        ASSERT_TRUE(read) << hex;
        EXPECT_EQ(*read, key) << hex;
    }
    for (const char* bad : {"", "0x", "0xg", "12 ", "0x-1", "0x100000000000000000000000000000000", "0x1x0"}) {
        const auto read = parseHex(bad);
        ASSERT_FALSE(read) << bad;
        EXPECT_EQ(read.error().code, "permutation.key");
    }
}

TEST(Key, RefusesReservedBits) {
    for (const ReservedBits& reserved : reservedBits())
        for (unsigned bit = 0; bit < reserved.bits; ++bit) {
            const auto read = fromKey(with(toKey({}), 1, reserved.shift + bit));
            ASSERT_FALSE(read) << reserved.name;
            EXPECT_EQ(read.error().code, "permutation.key");
            EXPECT_NE(read.error().what.find(reserved.name), std::string::npos) << read.error().what;
        }
}

TEST(Key, RefusesOtherSchemas) {
    for (unsigned version = 0; version < 1U << kSchemaBits.bits; ++version) {
        Key key = toKey({});
        key.words[1] ^= keyBits(version ^ kSchemaVersion, kSchemaBits.shift).words[1];
        const auto read = fromKey(key);
        EXPECT_EQ(read.has_value(), version == kSchemaVersion);
        if (!read) {
            EXPECT_EQ(read.error().code, "permutation.schema");
        }
    }
}

TEST(Key, RefusesValuesThatMeanNothing) {
    for (const Choice& choice : choices())
        for (std::uint64_t value = choice.options.size(); value < std::uint64_t{1} << choice.bits; ++value) {
            const auto read = fromKey(with(toKey({}), value, choice.shift));
            ASSERT_FALSE(read) << choice.name << " " << value;
            EXPECT_EQ(read.error().code, "permutation.key");
        }
}

struct Contradiction {
    std::string_view name, word;
};

constexpr Contradiction kContradictions[] = {
    {"occlusion-packed+ambient", "occlusion-packed"},
    {"metalrough-separate.occlusion-packed+ambient", "occlusion-packed"},
    {"uv0-transform+sun1", "uv0-transform"},
    {"basecolor.basecolor-uv1.uv0-transform", "uv0-transform"},
    {"basecolor.uv1-transform", "uv1-transform"},
    {"basecolor-uv1", "basecolor-uv1"},
    {"metalrough-uv1+sun1", "metalrough-uv1"},
    {"normal-uv1+sun1", "normal-uv1"},
    {"metalrough.occlusion-packed.occlusion-uv1+ambient", "occlusion-uv1"},
    {"emissive-factor.emissive-uv1", "emissive-uv1"},
    {"reflection+ambient+sun1", "reflection"},
    {"spots+sun1", "spots"},
    {"sun1+seed+energy", "energy"},
};

TEST(Canonical, RefusesContradictions) {
    for (const Contradiction& row : kContradictions) {
        const auto parsed = parseName(row.name);
        ASSERT_TRUE(parsed) << toString(parsed.error());
        const auto canonical = canonicalise(*parsed);
        ASSERT_FALSE(canonical) << row.name;
        EXPECT_EQ(canonical.error().code, "permutation.contradiction") << row.name;
        EXPECT_EQ(canonical.error().where, row.word) << row.name;
        EXPECT_FALSE(canonical.error().what.empty());
        EXPECT_FALSE(canonical.error().remedy.empty());
    }
}

TEST(Canonical, RefusesValuesOutOfRange) {
    Permutation p;
    p.suns = Permutation::kMaxLights + 1;
    const auto canonical = canonicalise(p);
    ASSERT_FALSE(canonical);
    EXPECT_EQ(canonical.error().code, "permutation.range");
    EXPECT_EQ(canonical.error().where, "suns");
}

struct NoOp {
    std::string_view name, canonical;
    std::vector<std::string> dropped;
};

const NoOp kNoOps[] = {
    {"normal", "surface", {"normal"}},
    {"basecolor.normal+ambient", "basecolor+ambient", {"normal"}},
    {"basecolor.normal+sun1", "basecolor.normal+sun1", {}},
    {"basecolor.normal.occlusion.unlit+ambient+sun2+seed",
     "basecolor.unlit",
     {"normal", "occlusion", "ambient", "sun2", "seed"}},
    {"sky+basecolor.blend+sun1", "sky", {"basecolor", "blend", "sun1"}},
    {"occlusion+sun1", "sun1", {"occlusion"}},
    {"sun1+punctual1+vertexlight", "sun1+punctual1", {"vertexlight"}},
    {"basecolor.unlit+decode-fast+srgb-fast+vc4", "basecolor.unlit+srgb-fast", {"decode-fast", "vc4"}},
    {"basecolor.normal+sun1+view-basecolor", "basecolor.unlit", {"view-basecolor", "normal", "sun1"}},
    {"metalrough.metalrough-uv1.uv1-transform+ambient",
     "ambient",
     {"metalrough", "metalrough-uv1", "uv1-transform"}},
};

TEST(Canonical, DropsNoOpsAndSaysWhich) {
    for (const NoOp& row : kNoOps) {
        const auto parsed = parseName(row.name);
        ASSERT_TRUE(parsed) << toString(parsed.error());
        const auto canonical = canonicalise(*parsed);
        ASSERT_TRUE(canonical) << toString(canonical.error());
        EXPECT_EQ(toName(canonical->permutation), row.canonical) << row.name;
        std::vector<std::string> words;
        for (const Dropped& dropped : canonical->dropped) {
            words.push_back(dropped.word);
            EXPECT_FALSE(dropped.reason.empty()) << dropped.word;
        }
        EXPECT_EQ(words, row.dropped) << row.name;
    }
}

} // namespace
} // namespace franken
