// SPDX-License-Identifier: MIT
// What a skin that moves costs in a thousand frames: no allocation of the library's and no program, on
// drivers that draw, with the context lost in the middle.
#include "franken/program_uses.h"
#include "support/draw_scene.h"
#include "support/heap_count.h"
#include "support/snake.h"

#include <gtest/gtest.h>

#include <optional>
#include <type_traits>

namespace franken::test {
namespace {

Gl driver;
std::size_t driverAllocations = 0, driverCompiles = 0;

template<auto Member>
struct Counted;

template<typename Return, typename... Arguments, Return (GL_APIENTRY* Gl::*Member)(Arguments...)>
struct Counted<Member> {
    static Return GL_APIENTRY call(Arguments... arguments) {
        const Count count;
        return (driver.*Member)(arguments...);
    }
    struct Count {
        std::size_t before = heapCount().calls;
        ~Count() { driverAllocations += heapCount().calls - before; }
    };
};

/// A table that counts what the driver allocates, and how often it compiles or links.
Gl countedGl(const Gl& real) {
    driver = real;
    Gl table;
#define FRANKEN_COUNT(function) table.function = Counted<&Gl::function>::call;
    FRANKEN_GL_FUNCTIONS(FRANKEN_COUNT)
#undef FRANKEN_COUNT
    table.CompileShader = [](GLuint shader) {
        ++driverCompiles;
        driver.CompileShader(shader);
    };
    table.LinkProgram = [](GLuint program) {
        ++driverCompiles;
        driver.LinkProgram(program);
    };
    return table;
}

constexpr int kSize = 32;

class MovingSkin : public PictureTest {
protected:
    MovingSkin() : PictureTest({kSize, kSize}) {}

    DrawTarget target() { return {.framebuffer = surface().framebuffer(), .width = kSize, .height = kSize}; }

    /// Draws the poses in turn; what that cost is then 0.
    void expectFreeFrames(Renderer& renderer, PlaceId place, int frames) {
        Camera camera;
        camera.world[3] = {0, 0, 7, 1};
        const Viewpoint viewpoint = viewpointOf(camera, 1);
        const auto draw = [&](int frame) {
            return renderer.setPose(place, m_poses[static_cast<std::size_t>(frame) % m_poses.size()]) &&
                   renderer.draw(viewpoint, target());
        };
        const unsigned links = renderer.programCounters().links;
        bool drawn = draw(0) && draw(1);
        driverAllocations = driverCompiles = 0;
        const std::size_t before = heapCount().calls;
        for (int frame = 2; frame < frames; ++frame)
            drawn = draw(frame) && drawn;
        const std::size_t allocations = heapCount().calls - before;
        EXPECT_TRUE(drawn);
        EXPECT_EQ(renderer.frameCounters().drawn, 1u);
        EXPECT_EQ(allocations - driverAllocations, 0u);
        EXPECT_EQ(driverCompiles, 0u);
        EXPECT_EQ(renderer.programCounters().links, links) << "the warm-up knew the programs";
    }

    const Snake m_snake{.influences = 4, .joints = 40, .target = true, .rings = 10};
    const Scene m_scene = sceneOf(m_snake);
    std::vector<Pose> m_poses = [&] {
        std::vector<Pose> poses;
        for (int number = 0; number < 20; ++number)
            poses.push_back(bent(m_scene, m_snake, 0.1 * number));
        return poses;
    }();
};

INSTANTIATE_TEST_SUITE_P(Backends, MovingSkin, allBackends(), backendName);

// Whether programs move the vertices, in parts, or the CPU does. Fewer frames of the latter, which take long.
TEST_P(MovingSkin, AllocatesAndCompilesNothingAndOutlastsTheContext) {
    const Lighting lighting = lightingOf(m_scene);
    const Result<std::vector<ProgramUse>> uses = usesOf(m_scene, lighting, {});
    ASSERT_TRUE(uses);
    for (const std::optional<Joints> joints : {std::optional(Joints::UpTo32), std::optional<Joints>()}) {
        const Capabilities capabilities{.maxTextureSize = 2048, .maxCubeSize = 2048, .joints = joints};
        Renderer renderer(countedGl(gl()), capabilities);
        renderer.setLighting(lighting);
        ASSERT_TRUE(renderer.warmUp(target(), *uses));
        EXPECT_GT(renderer.programCounters().links, 0u);
        const Result<ModelId> model = renderer.add(m_scene, [&] { return Result<Scene>(m_scene); });
        ASSERT_TRUE(model && renderer.show({{*model}}, Wait::Yes));
        const PlaceId place = *renderer.firstPlace(*model);
        const int frames = joints ? 500 : 50;
        expectFreeFrames(renderer, place, frames);
        const Picture before = readBack();

        renderer.contextLost();
        replaceContext({kSize, kSize});
        ASSERT_TRUE(renderer.restore(countedGl(gl()), capabilities));
        ASSERT_TRUE(renderer.warmUp(target(), *uses));
        expectFreeFrames(renderer, place, frames);
        EXPECT_EQ(compareLit(readBack(), before).max(), 0);
    }
}

} // namespace
} // namespace franken::test
