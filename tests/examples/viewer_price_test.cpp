// SPDX-License-Identifier: MIT
// What the viewer says of a picture's price.
#include "price/changes.h"
#include "viewer_run.h"

namespace franken::test {
namespace {

using ViewerPrice = Viewer;

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++count;
    return count;
}

TEST_F(ViewerPrice, IsToldForEachMachineBesideThePicture) {
    const std::string command = std::string(kUrn) + " --price pi3 --size 96x64 --tone-map aces";
    setenv("FRANKEN_QPU", "/nowhere", 1); // The tables of the source tree, the same everywhere.
    const Outcome outcome = run(command);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(m_folder / "out.png"));
    for (const char* part : {"96x64 on a Pi 3: ", "Pi 0, Pi Zero 2", "Pi 1, Pi 2", "\nPi 4 ", "\nPi 5 ",
                             "bound by", "(~), because", "these would bring most", "--tone-map clip"})
        EXPECT_NE(outcome.out.find(part), std::string::npos) << part << '\n' << outcome.out;

    const Outcome json = run(command + " --json");
    unsetenv("FRANKEN_QPU");
    ASSERT_EQ(json.code, 0) << json.err;
    EXPECT_EQ(json.out.find("{\n \"schema\": 1,"), 0u);
    EXPECT_EQ(countOf(json.out, "\"bound\""), 5u);
    EXPECT_EQ(countOf(json.out, "\"change\""), 3u) << json.out;
    EXPECT_EQ(countOf(json.out, "\"name\": \"vertexcolor+sun2+aces\""), 5u)
        << "a program of the urn, on each";
}

// What is advised can be typed: the option is taken, and only the model is not there.
TEST_F(ViewerPrice, AdvisesOptionsThatItTakes) {
    price::Terms terms;
    terms.look.toneMap = ToneMap::Neutral;
    terms.look.dither = Dither::Ordered;
    int options = 0;
    for (const price::Offer& offer : price::offersFor(terms)) {
        if (!offer.words.starts_with("--"))
            continue;
        ++options;
        const Outcome outcome = run("missing.glb " + offer.words);
        EXPECT_EQ(outcome.code, 3) << offer.words << '\n' << outcome.err;
    }
    EXPECT_EQ(options, 8);
}

TEST_F(ViewerPrice, NothingIsMeasuredWhereSoftwareDraws) {
    const Outcome outcome = run(std::string(kUrn) + " --price pi4 --size 32x32 --backend egl --measure");
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(outcome.out.find("32x32 on a Pi 4"), std::string::npos) << "the price is told all the same";
    EXPECT_NE(outcome.err.find("says nothing of a Raspberry Pi's GPU"), std::string::npos) << outcome.err;
}

TEST_F(ViewerPrice, WhatMakesNoSenseIsRefused) {
    for (const auto& [options, says] : {std::pair("--price pi6", "did you mean 'pi5'?"),
                                        {"--json", "--price"},
                                        {"--price pi3 --measure", "it needs --backend egl"},
                                        {"--price pi3 --turntable 3", "--turntable"}}) {
        const Outcome outcome = run(std::string(kUrn) + " " + options);
        EXPECT_EQ(outcome.code, 2) << options;
        EXPECT_NE(outcome.err.find(says), std::string::npos) << options << '\n' << outcome.err;
    }
}

} // namespace
} // namespace franken::test
