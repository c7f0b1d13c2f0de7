// SPDX-License-Identifier: MIT
// What may go wrong with models that come step by step: wrong data, sources that fail, drivers without
// memory, and calls at any moment. Each ends in an error with a code, and the renderer goes on.
#include "misuse_stage.h"

#include "franken/complete.h"
#include "franken/png.h"
#include "support/fault_driver.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

namespace franken::test {
namespace {

/// Steps until nothing is left; the codes of all errors.
std::vector<std::string> stepped(Renderer& renderer, std::chrono::microseconds budget = {}) {
    std::vector<std::string> codes;
    for (bool more = true; more;) {
        const Result<StepReport> report = renderer.step(budget);
        if (!report)
            codes.push_back(report.error().code);
        more = report ? report->more : codes.back() != "renderer.context-lost";
        std::this_thread::yield();
    }
    return codes;
}

std::string resident(const Renderer& renderer, ModelId model) {
    const Result<bool> answer = renderer.isResident(model);
    return !answer ? answer.error().code : *answer ? "yes" : "no";
}

const SceneSource kBallSource = [] { return Result<Scene>(ball()); };

/// A source that ends when it is let go.
class Gate {
public:
    SceneSource source() {
        return [this]() -> Result<Scene> {
            began = true;
            while (!open)
                std::this_thread::yield();
            return ball();
        };
    }
    void waitUntilItRuns(Renderer& renderer) const {
        while (!began)
            EXPECT_TRUE(renderer.step());
    }

    std::atomic<bool> began{false}, open{false};
};

TEST(Steps, WithNothingToDoDoNothing) {
    Stage stage;
    for (const auto budget : {std::chrono::microseconds::min(), std::chrono::microseconds(-1),
                              std::chrono::microseconds(0), std::chrono::microseconds::max()}) {
        const Result<StepReport> report = stage.renderer.step(budget);
        ASSERT_TRUE(report);
        EXPECT_TRUE(report->bytes == 0 && report->programs == 0 && !report->more);
    }
}

TEST(Steps, OfAnyBudgetLoadAll) {
    for (const auto budget : {std::chrono::microseconds::min(), std::chrono::microseconds(100),
                              std::chrono::microseconds::max()}) {
        Stage stage;
        const Result<ModelId> model = stage.renderer.addInSteps(ball());
        ASSERT_TRUE(model);
        EXPECT_TRUE(stepped(stage.renderer, budget).empty());
        EXPECT_EQ(resident(stage.renderer, *model), "yes");
    }
}

TEST(Steps, SayWhatIsWrongWithAModelAndGoOnWithTheNext) {
    Stage stage;
    Scene wrong = ball();
    wrong.meshes[0].primitives[0].normals.pop_back();
    const SceneSource fails = [] {
        return Result<Scene>(Error{"gltf.file", "vase.glb", "gone", "look for it"});
    };
    const SceneSource throws = []() -> Result<Scene> { throw std::runtime_error("of the application"); };
    const Result<ModelId> first = stage.renderer.addInSteps(wrong);
    const Result<ModelId> second = stage.renderer.add(ball(), fails),
                          third = stage.renderer.add(ball(), throws);
    const Result<ModelId> empty = stage.renderer.addInSteps({}), last = stage.renderer.addInSteps(ball());
    ASSERT_TRUE(first && second && third && empty && last);
    stage.renderer.memory().evictAll();
    ASSERT_TRUE(stage.renderer.show({{*first, *second, *third, *empty, *last}}));
    EXPECT_EQ(stepped(stage.renderer),
              (std::vector<std::string>{"scene.data", "gltf.file", "renderer.exception"}));
    EXPECT_EQ(resident(stage.renderer, *first), "scene.data");
    EXPECT_EQ(resident(stage.renderer, *second), "gltf.file");
    EXPECT_EQ(resident(stage.renderer, *third), "renderer.exception");
    EXPECT_EQ(resident(stage.renderer, *empty), "yes");
    EXPECT_EQ(resident(stage.renderer, *last), "yes");
    EXPECT_TRUE(stepped(stage.renderer).empty()) << "each is told once";
    EXPECT_TRUE(stage.draw());
    EXPECT_EQ(stage.renderer.frameCounters().drawn + stage.renderer.frameCounters().culled, 1u);
}

TEST(Steps, ACallOfWhatIsNotThereIsAnError) {
    Stage stage, other;
    const Result<ModelId> foreign = other.renderer.add(ball());
    const Result<ModelId> gone = stage.renderer.addInSteps(ball());
    ASSERT_TRUE(foreign && gone);
    stage.renderer.remove(*gone);
    for (const ModelId id : {*foreign, *gone, ModelId{}}) {
        EXPECT_EQ(resident(stage.renderer, id), "renderer.model");
        for (const Wait wait : {Wait::No, Wait::Yes})
            EXPECT_EQ(stage.renderer.show({{id}}, wait).error().code, "renderer.model");
    }
    const Result<ModelId> lost = stage.renderer.add(ball());
    stage.renderer.contextLost();
    EXPECT_EQ(stage.renderer.step().error().code, "renderer.context-lost");
    EXPECT_EQ(stage.renderer.show({}).error().code, "renderer.context-lost");
    const Result<ModelId> meanwhile = stage.renderer.addInSteps(ball());
    ASSERT_TRUE(meanwhile) << "needs no context";
    ASSERT_TRUE(stage.renderer.restore(stage.gl));
    EXPECT_EQ(resident(stage.renderer, *lost), "no");
    for (const Wait wait : {Wait::No, Wait::Yes})
        EXPECT_EQ(stage.renderer.show({{*lost}}, wait).error().code, "renderer.no-source");
    EXPECT_TRUE(stepped(stage.renderer).empty());
    EXPECT_EQ(resident(stage.renderer, *meanwhile), "yes");
    EXPECT_EQ(resident(stage.renderer, *lost), "no");
}

// All that can be asked for while the model is on its way counts when it is there.
TEST(Steps, CallsInTheMiddleCountAtTheEnd) {
    Scene scene = ball();
    scene.variants = {"night"};
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].factors.roughness = 0.25f;
    scene.meshes[0].primitives[0].variantMaterials = {1};
    const Result<PickTree> tree = PickTree::of(scene);
    ASSERT_TRUE(tree);
    for (int before = 0; before < 12; ++before) {
        Stage stage;
        const Result<ModelId> model = stage.renderer.addInSteps(scene);
        for (int i = 0; i < before; ++i)
            ASSERT_TRUE(stage.renderer.step());
        ASSERT_TRUE(model && stage.renderer.show({{*model}}));
        ASSERT_TRUE(stage.renderer.addPlace(*model, glm::dmat4(1)) && stage.renderer.firstPlace(*model));
        ASSERT_TRUE(stage.renderer.setVariant(*model, "night") && stage.renderer.setPickTree(*model, *tree));
        EXPECT_EQ(stage.renderer.setVariant(*model, "day").error().code, "renderer.variant");
        Result<Material> material = stage.renderer.materialOf(*model, 1);
        ASSERT_TRUE(material);
        EXPECT_EQ(material->factors.roughness, 0.25f);
        material->alphaMode = AlphaMode::Blend;
        ASSERT_TRUE(stage.renderer.setMaterial(*model, 1, *material));
        EXPECT_EQ(stage.renderer.setMaterial(*model, 2, *material).error().code, "renderer.material");
        ASSERT_TRUE(stage.renderer.setTexture(*model, 0, white(4, 4)));
        EXPECT_EQ(stage.renderer.setTexture(*model, 99, white(4, 4)).error().code, "renderer.texture");
        EXPECT_TRUE(stage.draw());
        EXPECT_TRUE(stepped(stage.renderer).empty());
        EXPECT_EQ(resident(stage.renderer, *model), "yes");
        EXPECT_EQ(stage.renderer.materialOf(*model, 1)->alphaMode, AlphaMode::Blend);
        EXPECT_TRUE(stage.draw());
        EXPECT_EQ(stage.renderer.frameCounters().drawn + stage.renderer.frameCounters().culled, 2u);
    }
}

// A material that was changed while its model was away may take a texture that none had before.
TEST(Steps, AMaterialThatWasChangedMeanwhileBringsItsTextures) {
    Stage stage;
    Scene scene = ball();
    scene.images.push_back(white(4, 4));
    scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1});
    const Result<ModelId> model = stage.renderer.add(scene, [&] { return Result<Scene>(scene); });
    ASSERT_TRUE(model);
    Material material = *stage.renderer.materialOf(*model, 0);
    material.textures[TextureRole::Emissive].texture = static_cast<int>(scene.textures.size()) - 1;
    ASSERT_TRUE(stage.renderer.setMaterial(*model, 0, material)) << "a texture that nothing is drawn with";
    Material glowing = material;
    glowing.factors.emissive = {1, 1, 1};
    EXPECT_EQ(stage.renderer.setMaterial(*model, 0, glowing).error().code, "renderer.material");
    EXPECT_EQ(stage.renderer.materialOf(*model, 0)->factors.emissive, (Float3{}));
    stage.renderer.memory().evictAll();
    ASSERT_TRUE(stage.renderer.show({{*model}}));
    EXPECT_TRUE(stepped(stage.renderer).empty());
    ASSERT_EQ(resident(stage.renderer, *model), "yes");
    ASSERT_TRUE(stage.renderer.show({}));
    stage.renderer.memory().evictAll();
    ASSERT_TRUE(stage.renderer.setMaterial(*model, 0, glowing));
    ASSERT_TRUE(stage.renderer.show({{*model}}));
    EXPECT_TRUE(stepped(stage.renderer).empty());
    EXPECT_EQ(resident(stage.renderer, *model), "yes");
}

TEST(Steps, AnImageThatCannotBeDecodedIsLeftOut) {
    std::vector<std::string> messages;
    Renderer renderer(nullGl(), [&](LogLevel, std::string_view text) { messages.emplace_back(text); });
    Scene scene = ball();
    for (Image& image : scene.images) {
        image.encoded = encodePng(image.width, image.height, 4, image.rgba);
        image.rgba.clear();
    }
    scene.images[1].encoded.resize(60);
    scene.images[1].name = "torn";
    Scene whole = scene;
    whole.images[1] = scene.images[0];
    const Result<ModelId> model = renderer.addInSteps(scene);
    ASSERT_TRUE(model);
    EXPECT_TRUE(stepped(renderer).empty());
    EXPECT_EQ(resident(renderer, *model), "yes");
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_NE(messages[0].find("images[1] \"torn\": "), std::string::npos) << messages[0];
    EXPECT_NE(messages[0].find("[gltf.left-out]"), std::string::npos);
    const std::size_t inSteps = renderer.memory().used();
    renderer.remove(*model);
    ASSERT_TRUE(renderer.add(scene));
    EXPECT_EQ(messages.size(), 2u);
    EXPECT_EQ(renderer.memory().used(), inSteps) << "as all at once";
}

TEST(Steps, AModelIsRemovedWhileItsSourceRuns) {
    Gate gate;
    Stage stage;
    const Result<ModelId> model = stage.renderer.add(ball(), gate.source());
    const Result<ModelId> next = stage.renderer.addInSteps(ball());
    stage.renderer.memory().evictAll();
    ASSERT_TRUE(model && next && stage.renderer.show({{*model}}));
    stage.renderer.remove(*next);
    gate.waitUntilItRuns(stage.renderer);
    stage.renderer.remove(*model); // Returns: the source is still at it.
    const Result<ModelId> other = stage.renderer.addInSteps(ball());
    for (int i = 0; i < 5; ++i)
        EXPECT_TRUE(stage.renderer.step()->more) << "the next one waits";
    EXPECT_EQ(resident(stage.renderer, *other), "no");
    gate.open = true;
    EXPECT_TRUE(stepped(stage.renderer).empty());
    EXPECT_EQ(resident(stage.renderer, *other), "yes");
}

// A step of any budget returns where it can do nothing: the source must not have to give up before.
TEST(Steps, NoTimeIsSpentOnWaitingForASourceOfARemovedModel) {
    std::atomic<bool> began{false}, open{false}, gaveUp{false};
    Stage stage;
    const Result<ModelId> model = stage.renderer.add(ball(), [&]() -> Result<Scene> {
        began = true;
        const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(5);
        while (!open && !gaveUp) {
            std::this_thread::yield();
            gaveUp = std::chrono::steady_clock::now() > last;
        }
        return ball();
    });
    stage.renderer.memory().evictAll();
    ASSERT_TRUE(model && stage.renderer.show({{*model}}));
    while (!began)
        ASSERT_TRUE(stage.renderer.step());
    stage.renderer.remove(*model);
    const Result<ModelId> next = stage.renderer.addInSteps(ball());
    EXPECT_TRUE(stage.renderer.step(std::chrono::microseconds::max())->more);
    EXPECT_FALSE(gaveUp);
    open = true;
    EXPECT_TRUE(stepped(stage.renderer).empty());
    EXPECT_EQ(resident(stage.renderer, *next), "yes");
}

TEST(Steps, TheContextIsLostWhileASourceRuns) {
    Gate gate;
    Stage stage;
    const Result<ModelId> model = stage.renderer.add(ball(), gate.source());
    stage.renderer.memory().evictAll();
    ASSERT_TRUE(model && stage.renderer.show({{*model}}));
    gate.waitUntilItRuns(stage.renderer);
    stage.renderer.contextLost();
    ASSERT_TRUE(stage.renderer.restore(stage.gl)) << "does not wait for it";
    EXPECT_TRUE(stage.renderer.step()->more);
    gate.open = true;
    EXPECT_TRUE(stepped(stage.renderer).empty());
    EXPECT_EQ(resident(stage.renderer, *model), "yes");
}

// A source is never called twice at a time: who waits, waits for the one that runs.
TEST(Steps, WaitingInTheMiddleEndsAtTheWholeModel) {
    for (int before = 0; before < 10; ++before) {
        Stage stage;
        std::atomic<int> running{0}, most{0};
        const SceneSource source = [&] {
            most = std::max<int>(most, ++running);
            Scene scene = ball();
            --running;
            return Result<Scene>(std::move(scene));
        };
        const Result<ModelId> model = stage.renderer.add(ball(), source);
        stage.renderer.memory().evictAll();
        ASSERT_TRUE(model && stage.renderer.show({{*model}}));
        for (int i = 0; i < before; ++i)
            ASSERT_TRUE(stage.renderer.step());
        ASSERT_TRUE(stage.renderer.show({{*model}}, Wait::Yes));
        EXPECT_EQ(resident(stage.renderer, *model), "yes");
        EXPECT_FALSE(stage.renderer.step()->more);
        EXPECT_EQ(most, 1);
    }
}

struct Driver {
    static inline int levels = 0;   ///< Of textures that were uploaded.
    static inline int refused = -1; ///< The level that there is no memory for.
    static inline bool owesError = false;

    static Gl make() {
        levels = 0;
        refused = -1;
        Gl gl = nullGl();
        gl.TexImage2D = [](GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {
            owesError = levels++ == refused;
        };
        gl.GetError = []() -> GLenum {
            return std::exchange(owesError, false) ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
        };
        return gl;
    }
};

TEST(Steps, ADriverWithoutMemoryIsHelpedByWhatCanBeEvicted) {
    for (int at = 0, levels = 1; at < levels; ++at) {
        Renderer renderer(Driver::make());
        const int before = Driver::levels;
        const Result<ModelId> hidden = renderer.add(ball(), kBallSource);
        ASSERT_TRUE(hidden);
        levels = Driver::levels - before;
        const std::size_t one = renderer.memory().used();
        Driver::refused = Driver::levels + at;
        const Result<ModelId> model = renderer.addInSteps(ball());
        ASSERT_TRUE(model);
        EXPECT_TRUE(stepped(renderer).empty());
        EXPECT_EQ(resident(renderer, *model), "yes") << at;
        EXPECT_EQ(resident(renderer, *hidden), "no");
        EXPECT_EQ(renderer.memory().used(), one);
    }
}

TEST(Steps, ADriverWithoutMemoryRefusesThatModelAlone) {
    for (int at = 0, levels = 1; at < levels; ++at) {
        Renderer renderer(Driver::make());
        const int before = Driver::levels;
        ASSERT_TRUE(renderer.load(ball()));
        levels = Driver::levels - before;
        const std::size_t shown = renderer.memory().used();
        Driver::refused = Driver::levels + at;
        const Result<ModelId> model = renderer.addInSteps(ball());
        ASSERT_TRUE(model);
        EXPECT_EQ(stepped(renderer), std::vector<std::string>{"renderer.memory"}) << at;
        EXPECT_EQ(resident(renderer, *model), "renderer.memory");
        EXPECT_EQ(renderer.memory().used(), shown) << "nothing stays of it";
        EXPECT_TRUE(renderer.draw({}, kTarget));
        EXPECT_EQ(renderer.frameCounters().drawn + renderer.frameCounters().culled, 1u);
        ASSERT_TRUE(renderer.show({{*model}})) << "tries again: the scene is still there";
        EXPECT_TRUE(stepped(renderer).empty());
        EXPECT_EQ(resident(renderer, *model), "yes");
    }
}

/// A small model in steps, on a driver with a fault; the codes of all errors. Then the next context is sound.
std::vector<std::string> stepsOn(const Gl& gl) {
    Renderer renderer(gl);
    Scene scene;
    scene.meshes = {{"", {plane({1, 1})}}};
    scene.instances = {{.name = ""}};
    scene.materials.resize(1);
    const Result<ModelId> model = renderer.addInSteps(scene);
    EXPECT_TRUE(model);
    std::vector<std::string> codes = stepped(renderer);
    if (const std::string state = resident(renderer, *model); state != "yes" && state != "no") {
        EXPECT_EQ(codes, std::vector<std::string>{state});
    }
    renderer.contextLost();
    EXPECT_TRUE(renderer.restore(nullGl()));
    renderer.setSnippets(SnippetSet::builtIn()); // Programs that the faulty driver refused are tried again.
    EXPECT_NE(resident(renderer, *model), "yes") << "that was in the other context";
    EXPECT_TRUE(renderer.load(ball()));
    EXPECT_TRUE(stepped(renderer).empty());
    return codes;
}

TEST(Steps, ADriverMayFailOrDieAtEachCall) {
    EXPECT_TRUE(stepsOn(faultyDriver(nullGl(), Fault::None, 0)).empty());
    const std::size_t calls = callsOfFaultyDriver();
    EXPECT_GT(calls, 50u);
    for (const Fault fault : {Fault::OneCall, Fault::Dies, Fault::DiesLoudly, Fault::EndlessErrors})
        for (std::size_t at = 0; at < calls; ++at)
            for (const std::string& code : stepsOn(faultyDriver(nullGl(), fault, at))) {
                EXPECT_TRUE(fault == Fault::OneCall || code == "renderer.context-lost")
                    << code << " of fault " << int(fault) << " at call " << at;
                EXPECT_FALSE(code.empty());
            }
}

} // namespace
} // namespace franken::test
