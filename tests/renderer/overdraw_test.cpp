// SPDX-License-Identifier: MIT
// How often a pixel is shaded: opaque surfaces of a program come front to back, masked ones last.
#include "numbers.h"

#include "support/gl_recorder.h"

#include <algorithm>

namespace franken::test {
namespace {

constexpr int kStep = 8; ///< What each shading of a pixel adds to it, codes.

/// A square that fills the picture, at that distance behind the plane z = 0.
struct Layer {
    float depth;
    int material;
};

class OverdrawTest : public PictureTest {
protected:
    /// The layers in that order, and with materials that add kStep each and differ in a factor alone.
    Shot shotOfLayers(const std::vector<Layer>& layers, const std::vector<AlphaMode>& materials) {
        SceneBuilder builder;
        std::vector<int> indices;
        for (std::size_t i = 0; i < materials.size(); ++i) {
            Material material;
            material.unlit = true;
            material.factors.baseColor = {kStep / 255.0f, kStep / 255.0f, static_cast<float>(i) / 255, 1};
            material.alphaMode = materials[i];
            indices.push_back(builder.addMaterial(material));
        }
        for (const Layer& layer : layers) {
            glm::mat4 world(1);
            world[3] = glm::vec4(0, 0, -layer.depth, 1);
            builder.add(square(), indices[static_cast<std::size_t>(layer.material)], world);
        }
        return filledBy(builder);
    }

    /// How often each pixel is shaded, which must be the same for all; `calls` of the frame.
    double shaded(const Shot& shot) {
        Renderer renderer(recordingGl(gl()));
        EXPECT_TRUE(renderer.load(shot.scene));
        renderer.setLook(shot.look);
        const DrawTarget target{.framebuffer = surface().framebuffer(), .width = 64, .height = 64};
        const Viewpoint viewpoint = viewpointOf(shot.camera, 1);
        EXPECT_TRUE(renderer.draw(viewpoint, target)); // Compiles, and proves what was compiled.
        gl().Enable(GL_BLEND); // Behind the renderer's back, which has no blended surface to blend.
        gl().BlendFunc(GL_ONE, GL_ONE);
        recordedCalls().clear();
        EXPECT_TRUE(renderer.draw(viewpoint, target));
        const Picture picture = readBack();
        gl().Disable(GL_BLEND);
        EXPECT_EQ(codesAt(picture, 1, 1), codesOf(picture));
        return static_cast<double>(codesOf(picture)[0]) / kStep;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, OverdrawTest, allBackends(), backendName);

TEST_P(OverdrawTest, OfThreeLayersOneIsShadedWhateverTheirOrder) {
    std::vector<Layer> layers = {{0, 0}, {1, 0}, {2, 0}};
    do {
        EXPECT_EQ(shaded(shotOfLayers(layers, {AlphaMode::Opaque})), 1);
    } while (std::next_permutation(layers.begin(), layers.end(),
                                   [](const Layer& a, const Layer& b) { return a.depth < b.depth; }));
}

TEST_P(OverdrawTest, MaterialsOfOneProgramAreSortedTogether) {
    EXPECT_EQ(shaded(shotOfLayers({{2, 0}, {1, 1}, {0, 0}, {3, 1}}, {AlphaMode::Opaque, AlphaMode::Opaque})),
              1);
    EXPECT_LE(countCalls("UseProgram"), 1u); // None where it is in use already.
}

// Within a slice, objects keep the order of their materials: a row of things as deep costs no more changes of
// state.
TEST_P(OverdrawTest, WhatIsAboutAsDeepStaysInTheOrderOfItsMaterials) {
    std::vector<Layer> layers = {{0, 0}, {50, 0}};
    for (int i = 0; i < 8; ++i)
        layers.push_back({10 + 0.01f * static_cast<float>(8 - i), i % 2});
    Shot shot = shotOfLayers(layers, {AlphaMode::Opaque, AlphaMode::Opaque});
    shot.camera.zfar = 100;
    shaded(shot);
    std::size_t changes = 0;
    for (const GlCall& call : recordedCalls())
        changes += call.name == "Uniform4fv" ? 1 : 0;
    EXPECT_EQ(changes, 2u)
        << "of the base colour: to the other material in the middle, and back for the far one";
}

TEST_P(OverdrawTest, MaskedSurfacesComeAfterAllThatHidesThem) {
    const std::vector<AlphaMode> materials = {AlphaMode::Mask, AlphaMode::Opaque};
    EXPECT_EQ(shaded(shotOfLayers({{1, 0}, {0, 1}}, materials)), 1);
    EXPECT_EQ(shaded(shotOfLayers({{0, 0}, {1, 1}}, materials)), 2) << "nothing hides the nearer one";
}

} // namespace
} // namespace franken::test
