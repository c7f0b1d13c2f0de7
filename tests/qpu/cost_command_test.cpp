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

TEST_F(Cost, HoldsALimit) {
    const Outcome within =
        run("cost basecolor.unlit+srgb-fast sky --gpu vc4 --gpu v3d42 --max vc4=1000 --max v3d42=1000");
    EXPECT_EQ(within.code, 0) << within.err;
    const Outcome above =
        run("cost basecolor.unlit+srgb-fast sky --gpu vc4 --gpu v3d42 --max vc4=30 --max v3d42=1000");
    EXPECT_EQ(above.code, 1);
    EXPECT_NE(above.out.find("vc4: max: the fragment shader has "), std::string::npos) << above.out;
    EXPECT_NE(above.out.find(" in sky\n"), std::string::npos) << above.out;
    EXPECT_EQ(above.out.find(" in basecolor.unlit+srgb-fast\n"), std::string::npos) << above.out;
}

/// The figures of a document of costs, changed.
template<typename Change>
std::string changed(const std::string& document, Change change) {
    Json costs = Json::parse(document);
    for (Json& cost : costs.at("costs"))
        change(cost);
    return costs.dump();
}

TEST_F(Cost, HoldsABaseline) {
    const std::string document = run("cost basecolor.unlit sky --gpu vc4 --json").out;
    const auto against = [&](const std::string& baseline, const std::string& more = "") {
        std::ofstream(path("costs.json")) << baseline;
        return run("cost basecolor.unlit sky --gpu vc4 --baseline costs.json" + more);
    };
    EXPECT_EQ(against(document).code, 0);

    struct Row {
        const char *shader, *figure;
        int by;
        const char* says;
    };
    for (const Row& row : {Row{"fragment", "instructions", -5, "fragment instructions went from"},
                           {"vertex", "instructions", -5, "vertex instructions went from"},
                           {"coordinate", "instructions", -5, "coordinate instructions went from"},
                           {"fragment", "threads", 1, "threads went from"}}) {
        const Outcome dearer = against(changed(document, [&](Json& cost) {
            Json& figure = cost.at(row.shader).at(row.figure);
            figure = figure.get<int>() + row.by;
        }));
        EXPECT_EQ(dearer.code, 1) << row.shader;
        EXPECT_NE(dearer.out.find(row.says), std::string::npos) << dearer.out;
    }
    const Outcome cheaper =
        against(changed(document, [](Json& cost) { cost["fragment"]["instructions"] = 900; }));
    EXPECT_EQ(cheaper.code, 0) << cheaper.out;

    const Outcome json =
        against(changed(document, [](Json& cost) { cost["fragment"]["instructions"] = 1; }), " --json");
    EXPECT_EQ(json.code, 1);
    const Json findings = Json::parse(json.out).at("findings");
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].at("program"), "basecolor.unlit");
    EXPECT_EQ(findings[0].at("check"), "baseline");
    EXPECT_EQ(findings[0].at("where"), "vc4");
}

TEST_F(Cost, ABaselineThatComparesNothingIsRefused) {
    std::ofstream(path("costs.json")) << run("cost sky --gpu v3d42 --json").out;
    const Outcome other = run("cost sky --gpu vc4 --baseline costs.json");
    EXPECT_EQ(other.code, 3);
    EXPECT_NE(other.err.find("none of these programs"), std::string::npos) << other.err;
    const Outcome partly = run("cost sky --gpu vc4 --gpu v3d42 --baseline costs.json");
    EXPECT_EQ(partly.code, 0) << partly.err;
    EXPECT_NE(partly.err.find("1 of 2 costs are not in costs.json"), std::string::npos) << partly.err;
}

TEST_F(Cost, FailsWhereNoRegistersAreFound) {
    const Outcome outcome =
        run("cost --gpu vc4 basecolor.vertexcolor.metalrough-separate.normal.occlusion.emissive."
            "mask.double.emissive-uv1.uv0-transform.uv1-transform+sh+sun4+punctual4+spots+seed");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.out.find("out of registers"), std::string::npos) << outcome.out;
}

} // namespace
