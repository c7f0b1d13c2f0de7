// SPDX-License-Identifier: MIT
// frankenshader cost, as a person or a script runs it.
#include "cli_runner.h"
#include "measure.h"

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

class Cost : public Cli {
protected:
    void SetUp() override {
        Cli::SetUp();
        // Sets FRANKEN_QPU, which the program inherits.
        if (!franken::test::compilers().compiler)
            GTEST_SKIP() << franken::test::compilers().whyNot;
    }
};

TEST_F(Cost, TellsHowToInstallTheCompilers) {
    const Outcome outcome = shell(std::string("FRANKEN_QPU=/nowhere ") + kProgram + " cost sun1");
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(outcome.err.find("toolchain.sh"), std::string::npos) << outcome.err;
}

TEST_F(Cost, RefusesOtherGpusAndNoName) {
    EXPECT_EQ(run("cost sun1 --gpu pi9").code, 2);
    EXPECT_EQ(run("cost").code, 2);
    EXPECT_EQ(run("cost nonsense").code, 3);
}

TEST_F(Cost, MeasuresWhatARuntimeWouldChoose) {
    const Outcome outcome = run("cost basecolor+sun1 --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json costs = Json::parse(outcome.out).at("costs");
    ASSERT_EQ(costs.size(), 3u);
    EXPECT_EQ(costs[0].at("gpu"), "vc4");
    EXPECT_EQ(costs[0].at("name"), "basecolor+sun1");
    EXPECT_EQ(costs[0].at("measured"), "basecolor+sun1+vc4");
    EXPECT_EQ(costs[1].at("gpu"), "v3d42");
    EXPECT_EQ(costs[2].at("gpu"), "v3d71");
    for (const Json& cost : costs) {
        EXPECT_GT(cost.at("fragment").at("instructions"), 20);
        EXPECT_GE(cost.at("fragment").at("threads"), 2);
        EXPECT_GT(cost.at("vertex").at("instructions"), cost.at("coordinate").at("instructions"));
        EXPECT_GE(cost.at("atMost").size(), 1u);
    }
}

TEST_F(Cost, ReadsAManifestAndKeepsItsOrder) {
    writeManifest("sky\nbasecolor.unlit # a comment\n");
    const Outcome outcome = run("cost --manifest warm.txt --gpu v3d71 --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json costs = Json::parse(outcome.out).at("costs");
    ASSERT_EQ(costs.size(), 2u);
    EXPECT_EQ(costs[0].at("name"), "sky");
    EXPECT_EQ(costs[1].at("name"), "basecolor.unlit");
}

TEST_F(Cost, IsReadableByPeople) {
    const Outcome outcome = run("cost basecolor.normal+sun1 --gpu vc4");
    EXPECT_EQ(outcome.code, 0);
    for (const char* text : {"fragment", "vertex", "coordinate", "Pi 3", "300 MHz", "pixels a vertex"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text << " is not in\n" << outcome.out;
}

// One process, one program or many: the figures are the same.
TEST_F(Cost, DoesNotDependOnWhatWasMeasuredBefore) {
    writeManifest("basecolor+sun1\nbasecolor.normal+sun2+vertexlight\nbasecolor+sun1+fast\n");
    for (const char* gpu : {"vc4", "v3d42", "v3d71"}) {
        const Json together =
            Json::parse(run(std::string("cost --manifest warm.txt --json --gpu ") + gpu).out).at("costs");
        for (const Json& cost : together) {
            const std::string name = cost.at("name");
            const Outcome alone = run("cost " + name + " --json --gpu " + gpu);
            EXPECT_EQ(Json::parse(alone.out).at("costs").at(0), cost);
        }
    }
}

TEST_F(Cost, FailsWhereNoRegistersAreFound) {
    const Outcome outcome =
        run("cost --gpu vc4 basecolor.vertexcolor.metalrough-separate.normal.occlusion.emissive."
            "mask.double.emissive-uv1.uv0-transform.uv1-transform+sh+sun4+punctual4+spots+seed");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.out.find("out of registers"), std::string::npos) << outcome.out;
}

} // namespace
