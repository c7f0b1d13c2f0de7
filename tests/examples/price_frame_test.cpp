// SPDX-License-Identifier: MIT
// The counts and the price of whole frames: against the renderer's own draws, and by hand.
#include "price/changes.h"
#include "price/frame_price.h"
#include "price/price_tables.h"
#include "support/draw_scene.h"
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <functional>

namespace price {
namespace {

using namespace franken;
using namespace franken::test;

constexpr int kStep = 8; ///< What each shading of a pixel adds to it, codes.
constexpr int kSize = 64;

FrameContents contentsOf(const Shot& shot) {
    return {.scene = shot.scene,
            .viewpoint = viewpointOf(tightened(shot.camera, shot.scene.bounds()), 1),
            .lighting = shot.lighting,
            .look = shot.look,
            .width = kSize,
            .height = kSize};
}

/// A square of 2 x 2 that fills the picture, so far behind the plane z = 0.
void addLayer(SceneBuilder& builder, int material, float depth) {
    glm::mat4 world(1);
    world[3] = glm::vec4(0, 0, -depth, 1);
    builder.add(square(), material, world);
}

Shot shotOf(const SceneBuilder& builder) {
    Shot shot{.scene = builder.scene, .camera = {}, .lighting = {}};
    shot.camera.projection = Camera::Projection::Orthographic;
    shot.camera.xmag = shot.camera.ymag = 1;
    shot.camera.zfar = 10;
    shot.camera.world[3] = glm::vec4(0, 0, 3, 1);
    shot.look.output = Output::Linear;
    return shot;
}

Material dim(AlphaMode mode) {
    Material material;
    material.unlit = true;
    material.factors.baseColor = {kStep / 255.0f, kStep / 255.0f, kStep / 255.0f, 1};
    material.alphaMode = mode;
    return material;
}

std::size_t pixelsOf(const std::vector<Shaded>& shaded) {
    std::size_t pixels = 0;
    for (const Shaded& each : shaded)
        pixels += each.pixels;
    return pixels;
}

TEST(PriceFrame, LayersAreSortedAsTheRendererSortsThem) {
    SceneBuilder builder;
    const int material = builder.addMaterial(dim(AlphaMode::Opaque));
    for (const float depth : {2.0f, 0.0f, 1.0f})
        addLayer(builder, material, depth);
    const Shot shot = shotOf(builder);
    const Result<FrameCounts> counts = countFrame(contentsOf(shot));
    ASSERT_TRUE(counts);
    ASSERT_EQ(counts->draws.size(), 3u);
    EXPECT_EQ(pixelsOf(shadedOf(*counts, EarlyDepth::Always)), kSize * kSize);
    EXPECT_EQ(counts->draws[0].vertices, 4u);
    EXPECT_EQ(counts->draws[0].tileVertices, 4u) << "one tile";
}

// v3d gives up early depth for the rest of the frame, vc4 does not.
TEST(PriceFrame, BehindAMaskV3dShadesWhatVc4DoesNot) {
    SceneBuilder builder;
    const int mask = builder.addMaterial(dim(AlphaMode::Mask)),
              solid = builder.addMaterial(dim(AlphaMode::Opaque));
    addLayer(builder, mask, 1);
    addLayer(builder, solid, 0);
    addLayer(builder, solid, 2);
    const Shot shot = shotOf(builder);
    const Result<FrameCounts> counts = countFrame(contentsOf(shot));
    ASSERT_TRUE(counts);
    EXPECT_EQ(pixelsOf(shadedOf(*counts, EarlyDepth::Always)), kSize * kSize);
    EXPECT_EQ(pixelsOf(shadedOf(*counts, EarlyDepth::UntilDiscard)), 2 * kSize * kSize) << "and the mask";
}

// As many texels as pixels; four times as many, of which the next level has as many as pixels, and the one
// after it a quarter; that texture at half its size.
TEST(PriceFrame, TexelsAreThoseUnderThePixels) {
    for (const auto& [size, texels, halved] :
         {std::array{64.0, 1.0, 0.25}, {128.0, 1.25, 1.0}, {32.0, 0.25, 0.0625}}) {
        SceneBuilder builder;
        Material material = dim(AlphaMode::Opaque);
        material.textures[TextureRole::BaseColor].texture =
            builder.addTexture(paint(static_cast<int>(size), [](glm::vec2) { return glm::vec4(1); }));
        addLayer(builder, builder.addMaterial(material), 0);
        const Shot shot = shotOf(builder);
        const Result<FrameCounts> counts = countFrame(contentsOf(shot));
        ASSERT_TRUE(counts);
        EXPECT_DOUBLE_EQ(counts->draws[0].texels.whole, 4 * kSize * kSize * texels) << size;
        EXPECT_DOUBLE_EQ(counts->draws[0].texels.halved, 4 * kSize * kSize * halved) << size;
        EXPECT_EQ(counts->draws[0].lookups, 2) << "two levels are mixed";
    }
}

TEST(PriceFrame, BlendedSurfacesComeLastAndHideNothing) {
    SceneBuilder builder;
    Material glass = dim(AlphaMode::Blend);
    glass.doubleSided = true;
    const int blended = builder.addMaterial(glass), solid = builder.addMaterial(dim(AlphaMode::Opaque));
    addLayer(builder, blended, 0);
    addLayer(builder, blended, 1);
    addLayer(builder, solid, 2);
    const Shot shot = shotOf(builder);
    FrameContents contents = contentsOf(shot);
    contents.skyboxSize = 16;
    const Result<FrameCounts> counts = countFrame(contents);
    ASSERT_TRUE(counts);
    ASSERT_EQ(counts->draws.size(), 6u) << "the solid one, the sky, and both sides of each";
    EXPECT_TRUE(counts->draws[1].isSkybox);
    EXPECT_EQ(counts->draws[1].shaded.pixels, 0u) << "it is hidden";
    EXPECT_EQ(pixelsOf(shadedOf(*counts, EarlyDepth::Always)), 3 * kSize * kSize)
        << "back faces of squares that are seen from the front have no pixels";
}

class PriceFrameDrawn : public PictureTest {};
INSTANTIATE_TEST_SUITE_P(Backends, PriceFrameDrawn, allBackends(), backendName);

/// How often pixels are shaded in all: each shading adds kStep.
double shadedBy(Renderer& renderer, const Gl& gl, const Viewpoint& viewpoint, const DrawTarget& target,
                const std::function<Picture()>& read) {
    EXPECT_TRUE(renderer.draw(viewpoint, target)); // Compiles, and proves what was compiled.
    gl.Enable(GL_BLEND); // Behind the renderer's back, which has no blended surface to blend.
    gl.BlendFunc(GL_ONE, GL_ONE);
    EXPECT_TRUE(renderer.draw(viewpoint, target));
    const Picture picture = read();
    gl.Disable(GL_BLEND);
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        sum += picture.rgba[i];
    return sum / kStep;
}

// Spheres in each other's way, some turned round by a mirror, one partly beside the picture: the rasteriser
// of another shades as many pixels, but for those on edges.
TEST_P(PriceFrameDrawn, AsManyPixelsAreCountedAsTheRendererHasShaded) {
    SceneBuilder builder;
    const int material = builder.addMaterial(dim(AlphaMode::Opaque));
    for (int i = 0; i < 9; ++i) {
        glm::mat4 world(0.4f + 0.05f * static_cast<float>(i));
        if (i % 2 == 1)
            world[0] = -world[0];
        world[3] = glm::vec4(-1 + 0.25f * static_cast<float>(i), 0.3f * static_cast<float>(i % 3) - 0.3f,
                             -0.4f * static_cast<float>(i * 5 % 9), 1);
        builder.add(sphere(12), material, world);
    }
    const Shot shot = shotOf(builder);
    Renderer renderer(gl());
    ASSERT_TRUE(renderer.load(shot.scene));
    renderer.setLook(shot.look);
    const DrawTarget target{.framebuffer = surface().framebuffer(), .width = kSize, .height = kSize};
    const FrameContents contents = contentsOf(shot);
    const double shaded = shadedBy(renderer, gl(), contents.viewpoint, target, [this] { return readBack(); });
    const Result<FrameCounts> counts = countFrame(contents);
    ASSERT_TRUE(counts);
    const auto counted = static_cast<double>(pixelsOf(shadedOf(*counts, EarlyDepth::Always)));
    EXPECT_GT(counted, 1000);
    EXPECT_NEAR(counted / shaded, 1, 0.01);
}

Machine machineOf(std::string_view word) {
    for (const Machine& machine : machines())
        if (machine.model.word == word)
            return machine;
    ADD_FAILURE() << word;
    return machines().front();
}

// 100 instructions in 1,024 blocks of four pixels: 409,600, of which a Pi 3 does 12 * 4 * 300 M a second.
TEST(PriceBill, IsWhatIsCountedByHand) {
    FrameCounts counts{.width = 64, .height = 64, .draws = {}};
    counts.draws.push_back({.plan = {},
                            .shaded = {4000, 1024},
                            .covered = {8000, 2048},
                            .vertices = 1000,
                            .tileVertices = 1200,
                            .vertexBytes = 32,
                            .texels = {1e6, 25e4},
                            .lookups = 2});
    const Permutation program;
    const ProgramCost cost{.fragment = 100, .vertex = 40, .coordinate = 20, .threads = 2};
    const Terms terms;
    const FrameBill bill = billOf(counts, terms, machineOf("pi3"), {&program, 1}, {&cost, 1});
    EXPECT_DOUBLE_EQ(bill.pixels, 409'600 / 14.4e6);
    EXPECT_DOUBLE_EQ(bill.vertices, (1000 * 20 + 1200 * 40) / 14.4e6);
    EXPECT_DOUBLE_EQ(bill.textureUnits, 8000 / (6 * 300e3));
    EXPECT_DOUBLE_EQ(bill.traffic.sum(), 1e6 + 1000 * 12 + 1200 * 32 + 64 * 64 * 4);
    EXPECT_DOUBLE_EQ(bill.memory, bill.traffic.sum() / (0.5 * 3600e3));
    EXPECT_EQ(bill.bound(), Bound::Memory);
    EXPECT_DOUBLE_EQ(bill.least(), bill.memory);
    const Terms halved{.lighting = {}, .look = {}, .halvedTextures = true};
    EXPECT_DOUBLE_EQ(billOf(counts, halved, machineOf("pi3"), {&program, 1}, {&cost, 1}).traffic.texels,
                     25e4);
    EXPECT_DOUBLE_EQ(billOf(counts, terms, machineOf("pi4"), {&program, 1}, {&cost, 1}).pixels,
                     409'600 / 16e6);
}

TEST(PriceTablesTest, AProgramOfTheTableIsTakenAsItIsAndOthersByTheirFeatures) {
    const PriceTables tables("gpu\tname\toutcome\tfragment\tthreads\tu\tt\ts\tf\tvertex\tcoordinate\tb\n"
                             "vc4\tsun1\tok\t120\t1\t0\t0\t0\t0\t76\t38\t-\n"
                             "v3d42\tsun1\tok\t90\t4\t0\t0\t0\t0\t60\t30\t-\n"
                             "vc4\tsky\tok\t63\t2\t0\t0\t0\t0\t23\t17\t-\n",
                             "| a | vc4 | v3d 4.2 | v3d 7.1 |\n|---|---|---|---|\n"
                             "| 2nd sun | +61 (+3) | +40 | +30 |\n| normal map | −3 (+47) | +14 | +17 |\n");
    const auto programOf = [](const char* name) { return *parseName(name); };
    const ProgramCost known = tables.of("vc4", programOf("sun1"));
    EXPECT_EQ(known.known, Known::Table);
    EXPECT_EQ(known.fragment, 120);
    EXPECT_EQ(known.threads, 1);
    const ProgramCost other = tables.of("vc4", programOf("normal+sun2"));
    EXPECT_EQ(other.known, Known::Interpolated);
    EXPECT_EQ(other.fragment, 120 + 61 - 3);
    EXPECT_EQ(other.vertex, 76 + 3 + 47);
    EXPECT_EQ(other.coordinate, 38);
    EXPECT_EQ(tables.of("vc4", programOf("sky+dither")).fragment, 63) << "the sky's own row is the nearest";
    EXPECT_FALSE(tables.of("v3d71", programOf("sun1")).error.empty());
}

// Each feature has its line in the list, or it would silently cost nothing.
TEST(PriceTablesTest, TheCommittedListIsNearWhatWasMeasured) {
    const PriceTables tables(kCostsTable, kPriceList);
    std::string withoutARow(kCostsTable);
    const std::string name = "basecolor.metalrough+sun2+fast";
    for (std::size_t at = 0; (at = withoutARow.find("\t" + name + "\t")) != std::string::npos;)
        withoutARow.erase(withoutARow.rfind('\n', at),
                          withoutARow.find('\n', at) - withoutARow.rfind('\n', at));
    const Permutation program = *parseName(name);
    for (const char* gpu : {"vc4", "v3d42", "v3d71"}) {
        const ProgramCost measured = tables.of(gpu, program);
        ASSERT_EQ(measured.known, Known::Table);
        const ProgramCost estimated = PriceTables(withoutARow, kPriceList).of(gpu, program);
        EXPECT_EQ(estimated.known, Known::Interpolated);
        EXPECT_NEAR(estimated.fragment, measured.fragment, 0.15 * measured.fragment) << gpu;
    }
}

TEST(PriceChanges, AreOfferedWhereThereIsSomethingToChange) {
    Terms terms;
    terms.look.toneMap = ToneMap::Aces;
    terms.lighting.suns.resize(2);
    const std::vector<Offer> offers = offersFor(terms);
    const auto has = [&](std::string_view words) {
        return std::any_of(offers.begin(), offers.end(),
                           [&](const Offer& offer) { return offer.words == words; });
    };
    EXPECT_TRUE(has("--tone-map clip"));
    EXPECT_TRUE(has("--tone-map reinhard"));
    EXPECT_TRUE(has("--light-vectors vertex"));
    EXPECT_TRUE(has("one sun less"));
    EXPECT_FALSE(has("one point or spot light less"));
    EXPECT_FALSE(has("no --energy"));
}

} // namespace
} // namespace price
