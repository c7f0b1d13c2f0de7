// SPDX-License-Identifier: MIT
// The viewer as a shell sees it.
#include "franken/baked_sky.h"
#include "franken/gltf.h"
#include "franken/manifest.h"
#include "viewer_run.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

TEST_F(Viewer, DrawsTheSamePictureOnBothBackends) {
    const std::string model = std::string(kUrn) + " --size 80x60 ";
    for (const std::string backend : {"osmesa", "egl"}) {
        const Outcome outcome = run(model + "--backend " + backend + " -o " + backend + ".png");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    const Picture osmesa = readPicture(m_folder / "osmesa.png");
    EXPECT_EQ(osmesa.width, 80);
    EXPECT_EQ(osmesa.height, 60);
    const Difference difference = compareLit(osmesa, readPicture(m_folder / "egl.png"));
    EXPECT_GT(difference.pixels, 300u);
    EXPECT_EQ(difference.max(), 0) << difference;
}

TEST_F(Viewer, SupersamplingMakesEdgesSoft) {
    const std::string model = std::string(kUrn) + " --size 80x60 ";
    EXPECT_EQ(run(model + "-o plain.png").code, 0);
    EXPECT_EQ(run(model + "-o soft.png --supersample").code, 0);
    const Picture soft = readPicture(m_folder / "soft.png");
    EXPECT_EQ(soft.width, 80);
    const Difference difference = compareLit(soft, readPicture(m_folder / "plain.png"));
    EXPECT_GT(difference.mean, 1);
    EXPECT_LT(std::abs(difference.bias), 4);
}

TEST_F(Viewer, PrintsThePermutationsThatItNeeds) {
    const Outcome outcome = run(std::string(kUrn) + " --permutations --brdf seed");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Result<std::vector<ProgramUse>> uses = parseManifest(outcome.out, "stdout");
    ASSERT_TRUE(uses) << toString(uses.error());
    EXPECT_GE(uses->size(), 1u);
    for (const ProgramUse& use : *uses)
        EXPECT_EQ(use.permutation.brdf, Brdf::Seed) << toName(use.permutation);
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
}

TEST_F(Viewer, CompilesBeforeTheFrameAndNothingInIt) {
    for (const std::string backend : {"osmesa", "egl"}) {
        const Outcome outcome = run(std::string(kUrn) + " --size 40x30 --stats --backend " + backend);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << "a progress line is for terminals";
        const ViewerStats stats = lastStats(outcome.out);
        EXPECT_GT(stats.compiled, 1u);
        EXPECT_GT(stats.linked, 1u);
        EXPECT_GE(stats.draws, stats.linked - 1) << "one program may be there to reset textures";
        EXPECT_EQ(stats.failed, 0u);
        EXPECT_EQ(stats.frameCompiled, 0u);
        EXPECT_EQ(stats.frameLinked, 0u);
        EXPECT_GT(stats.primitives, 0u);
        EXPECT_GT(stats.mebibytes, 0.1f);
    }
}

TEST_F(Viewer, RefusesWhatWouldDestroyItsInput) {
    fs::copy_file(kUrn, m_folder / "urn.glb");
    const std::string model = readText(m_folder / "urn.glb");
    EXPECT_EQ(run("urn.glb -o urn.glb").code, 2);
    EXPECT_EQ(run("urn.glb -o ./urn.glb --size 8x8").code, 2);
    EXPECT_EQ(readText(m_folder / "urn.glb"), model);
    std::ofstream(m_folder / "notes.txt") << "Buy milk.\n";
    EXPECT_NE(run("urn.glb --size 8x8 --manifest notes.txt").code, 0);
    EXPECT_EQ(readText(m_folder / "notes.txt"), "Buy milk.\n");
}

TEST_F(Viewer, RefusesWhatWouldDestroyAFileOfItsModel) {
    std::ofstream(m_folder / "model.gltf") << R"({"asset":{"version":"2.0"},"images":[{"uri":"a%20b.png"}],)"
                                              R"("buffers":[{"uri":"data.bin","byteLength":4}]})";
    for (const char* file : {"a b.png", "data.bin"})
        std::ofstream(m_folder / file) << "four";
    for (const char* options : {"-o 'a b.png'", "-o data.bin", "-o ./data.bin"})
        EXPECT_EQ(run(std::string("model.gltf ") + options).code, 2) << options;
    for (const char* file : {"a b.png", "data.bin"})
        EXPECT_EQ(readText(m_folder / file), "four");
}

TEST_F(Viewer, ABackgroundIsWhatADisplayShows) {
    for (const char* color : {"9,9,9", "0,1.01,0", "-1,0,0", "nan,0,0"})
        EXPECT_EQ(run(std::string(kUrn) + " --background " + color).code, 2) << color;
    EXPECT_EQ(run(std::string(kUrn) + " --size 8x8 --background 1,0,1").code, 0);
}

// What grows without end, hangs, or takes a gigabyte, is refused at once and in little memory.
TEST_F(Viewer, AHeightMapIsAnOrdinaryFileOfModestSize) {
    fs::create_directory(m_folder / "folder");
    EXPECT_EQ(runIn(m_folder, "mkfifo pipe").code, 0);
    std::ofstream(m_folder / "empty.png");
    std::ofstream(m_folder / "large.png").seekp(80 << 20).put(0);
    // A header alone: 100,000 pixels wide and high.
    std::ofstream(m_folder / "huge.png")
        << std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x01\x86\xa0\0\x01\x86\xa0\x08\x06\0\0\0", 29)
        << "crc.";
    const bool device = runIn(m_folder, "mknod zero c 1 5 && head -c 1 zero >/dev/null").code == 0;
    for (const std::string map :
         {"folder", "pipe", "zero", "empty.png", "large.png", "huge.png", "missing.png"}) {
        if (map == "zero" && !device)
            continue;
        const Outcome outcome = runIn(m_folder, "timeout 20 " VIEWER " '" + std::string(kUrn) +
                                                    "' --size 8x8 --height-map " + map);
        EXPECT_EQ(outcome.code, 3) << map << outcome.err;
        EXPECT_NE(outcome.err.find("viewer: error: " + map + ": "), std::string::npos) << outcome.err;
    }
}

TEST_F(Viewer, AManifestGrowsByWhatItLacksAndIsWarmedUp) {
    const std::string urn = std::string(kUrn) + " --size 40x30 --stats ";
    const Outcome first = run(urn + "--manifest kiosk.txt");
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_NE(first.err.find("the manifest is not used for the warm-up"), std::string::npos) << first.err;
    const std::string plain = readText(m_folder / "kiosk.txt");
    EXPECT_EQ(plain, run(std::string(kUrn) + " --permutations").out);

    const Outcome second = run(urn + "--manifest kiosk.txt --tone-map aces");
    EXPECT_EQ(second.code, 0);
    EXPECT_EQ(second.err, "");
    const ViewerStats both = lastStats(second.out);
    EXPECT_GT(both.linked, lastStats(run(urn + "--tone-map aces").out).linked);
    EXPECT_EQ(both.frameLinked, 0u);
    const std::string grown = readText(m_folder / "kiosk.txt");
    const auto before = parseManifest(plain, "before"), after = parseManifest(grown, "after");
    ASSERT_TRUE(before && after);
    EXPECT_EQ(after->size(), 2 * before->size());

    EXPECT_EQ(lastStats(run(urn + "--manifest kiosk.txt").out).linked, both.linked);
    EXPECT_EQ(readText(m_folder / "kiosk.txt"), grown);
}

TEST_F(Viewer, AManifestThatWasCutIsWrittenAnewAndAnotherFileIsNot) {
    const std::string urn = std::string(kUrn) + " --size 40x30 --manifest ";
    ASSERT_EQ(run(urn + "kiosk.txt").code, 0);
    const std::string whole = readText(m_folder / "kiosk.txt");
    std::ofstream(m_folder / "kiosk.txt") << whole.substr(0, whole.size() - 3);
    const Outcome cut = run(urn + "kiosk.txt");
    EXPECT_EQ(cut.code, 0);
    EXPECT_NE(cut.err.find("[manifest.damaged]"), std::string::npos) << cut.err;
    EXPECT_EQ(readText(m_folder / "kiosk.txt"), whole);

    const std::string typo = "# mine\nbasecolor+sun1\nbasecolour+sun2\n";
    std::ofstream(m_folder / "mine.txt") << typo;
    const Outcome wrong = run(urn + "mine.txt");
    EXPECT_EQ(wrong.code, 3);
    EXPECT_NE(wrong.err.find("mine.txt:3"), std::string::npos) << wrong.err;
    EXPECT_EQ(readText(m_folder / "mine.txt"), typo);

    const Outcome nowhere = run(urn + "no/such/folder.txt -o there.png");
    EXPECT_EQ(nowhere.code, 4);
    EXPECT_NE(nowhere.err.find("[manifest.write]"), std::string::npos) << nowhere.err;
    EXPECT_TRUE(fs::exists(m_folder / "there.png"));
}

/// 512 x 256 texels of one radiance.
void writeSky(const fs::path& file) {
    std::ofstream sky(file, std::ios::binary);
    sky << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 256 +X 512\n";
    for (int i = 0; i < 512 * 256; ++i)
        sky.write("\x40\x40\x40\x80", 4);
}

TEST_F(Viewer, LoadingTakesNoMoreMemoryThanItMay) {
    const std::string urn = std::string(kUrn) + " --permutations --memory ";
    for (const char* wrong : {"0", "4096", "-1", "much"})
        EXPECT_EQ(run(urn + wrong).code, 2) << wrong;
    const Outcome refused = run(urn + "1");
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("raise --memory"), std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find("LoadOptions"), std::string::npos) << refused.err;
    EXPECT_EQ(run(urn + "240").code, 0);

    writeSky(m_folder / "flat.hdr");
    const Outcome sky = run(urn + "1 --skybox flat.hdr");
    EXPECT_EQ(sky.code, 3);
    EXPECT_NE(sky.err.find("[sky.limit]"), std::string::npos) << sky.err;
    EXPECT_NE(sky.err.find("raise --memory"), std::string::npos) << sky.err;
}

/// A sky as `bake` writes it, with textures of the right size that are black: quicker than filtering one.
void writeBakedSky(const fs::path& file, int skyboxSize) {
    BakedSky sky;
    sky.skybox = encodeSkybox(
        {Environment::Layout::Equirect, 2, 1, std::vector<glm::vec3>(2, glm::vec3(0.5f))}, skyboxSize);
    const auto black = [](int width, int height) {
        return Image{"", width, height,
                     std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
    };
    sky.reflection.atlas = {black(2 * kReflectionSize, reflectionHeight(kReflectionSize)), kMinSkyRange};
    sky.reflection.lookup = black(kLookupWidth, kLookupHeight);
    const auto bytes = encodeBakedSky(sky);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// A narrow picture is as sharp as a wide one, and quicker drawn.
TEST_F(Viewer, SaysWhenTheSkyboxIsMagnified) {
    writeBakedSky(m_folder / "flat.sky", 128);
    const Outcome small = run(std::string(kUrn) + " --skybox flat.sky --size 4x30");
    EXPECT_EQ(small.code, 0) << small.err;
    EXPECT_EQ(small.err.find("magnified"), std::string::npos) << small.err;

    const Outcome large = run(std::string(kUrn) + " --skybox flat.sky --size 8x400");
    EXPECT_EQ(large.code, 0) << large.err;
    const auto scene = loadGltf(kUrn);
    ASSERT_TRUE(scene);
    const double needed = 400 / std::tan(0.5 * static_cast<double>(scene->cameras.at(0).yfov));
    std::array<char, 32> texels{};
    std::snprintf(texels.data(), texels.size(), "%.2f texels", 128 / needed);
    const std::string size = std::to_string(static_cast<int>(std::ceil(needed)));
    EXPECT_NE(large.err.find(texels.data()), std::string::npos) << large.err;
    EXPECT_NE(large.err.find("--skybox-size " + size), std::string::npos) << large.err;
}

// The least that the viewer takes is the least that the library takes: --memory is in MiB, and no more.
// Four textures of 2048 x 2048: 85 MiB in the driver, and as much again for whoever decodes all before
// uploading one.
TEST_F(Viewer, AModelOfLargeTexturesTakesLittleBesideTheDriver) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a sanitizer's memory is not the program's";
#endif
    const fs::path model = findShared("assets/valid/khronos/WaterBottle/WaterBottle.gltf");
    if (model.empty())
        GTEST_SKIP() << "needs ../shared/assets/valid beside the sources";
    const std::string command = VIEWER " --size 64x64 ";
    const long small = peakKiBIn(m_folder, command + "'" + std::string(kUrn) + "'");
    const long large = peakKiBIn(m_folder, command + "'" + model.string() + "' --stats");
    const float textures = lastStats(readText(m_folder / "out")).mebibytes;
    EXPECT_GT(textures, 80);
    EXPECT_LT(large - small, static_cast<long>(1024 * (textures + 32))) << "beside one image";
}

TEST_F(Viewer, MemoryIsCountedInMebibytes) {
    std::size_t least = 1;
    while (!loadGltf(kUrn, {.maxMemoryBytes = least << 20, .images = ImageForm::Encoded}))
        ASSERT_LT(++least, 100u);
    ASSERT_GE(least, 2u);
    const std::string urn = std::string(kUrn) + " --permutations --memory ";
    EXPECT_EQ(run(urn + std::to_string(least)).code, 0);
    EXPECT_EQ(run(urn + std::to_string(least - 1)).code, 3);
}

TEST_F(Viewer, APictureThatCannotBeWrittenWholeLeavesTheOneBefore) {
    ASSERT_EQ(run(std::string(kUrn) + " --size 40x30").code, 0);
    const std::string good = readText(m_folder / "out.png");
    const Outcome full =
        runIn(m_folder, "trap '' XFSZ; ulimit -f 8; " VIEWER " '" + std::string(kUrn) + "' --size 400x300");
    EXPECT_EQ(full.code, 4) << full.err;
    EXPECT_EQ(readText(m_folder / "out.png"), good);
    for (const auto& entry : fs::directory_iterator(m_folder))
        EXPECT_NE(entry.path().extension(), ".new") << "a temporary file is left";
}

TEST_F(Viewer, HelpShowsAnExample) {
    const Outcome outcome = run("--help");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("Example: viewer"), std::string::npos);
}

TEST_F(Viewer, ExitCodesTellWhoseFaultItIs) {
    const std::string urn = kUrn;
    EXPECT_EQ(run("").code, 2);
    EXPECT_EQ(run(urn + " --size 0x5").code, 2);
    EXPECT_EQ(run(urn + " --size 9000x30").code, 2);
    EXPECT_EQ(run(urn + " --sun 0,0,0").code, 2);
    EXPECT_EQ(run(urn + " --exposure 0").code, 2);
    EXPECT_EQ(run(urn + " --exposure -1").code, 2);
    EXPECT_EQ(run(urn + " --sun 1,2:3").code, 2);
    EXPECT_EQ(run(urn + " --camera nobody").code, 2);
    EXPECT_EQ(run(urn + " --tone-map loud").code, 2);
    EXPECT_EQ(run(urn + " --sun 0,-1,0 --sun 0,-1,0 --sun 0,-1,0 --sun 0,-1,0 --sun 0,-1,0").code, 2);
    EXPECT_EQ(run("missing.gltf").code, 3);
    EXPECT_EQ(run(urn + " --skybox missing.hdr").code, 3);
    EXPECT_EQ(run(urn + " --size 40x30 -o no/such/folder.png").code, 4);
    EXPECT_NE(run("missing.gltf").err.find("missing.gltf"), std::string::npos);
}

TEST_F(Viewer, SnippetsOfItsOwnMustCompile) {
    copySnippets();
    const std::string urn = std::string(kUrn) + " --size 40x30 --snippets glsl";
    EXPECT_EQ(run(urn).code, 0);
    std::ofstream(m_folder / "glsl/fragment/ambient/none.glsl", std::ios::app)
        << "  sum.specular += nonsense;\n";
    EXPECT_EQ(run(urn).code, 4);
    fs::remove(m_folder / "glsl/fragment/ambient/none.glsl");
    EXPECT_EQ(run(urn).code, 3);
}

TEST_F(Viewer, DrawsUnderASkyByOthers) {
    const fs::path sky = findShared("assets/env/venice.hdr");
    if (sky.empty())
        GTEST_SKIP() << "needs ../shared/assets/env beside the sources";
    const Outcome outcome =
        run(std::string(kUrn) + " --size 80x60 --tone-map neutral --skybox " + sky.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Picture picture = readPicture(m_folder / "out.png");
    const std::uint8_t* const corner = picture.rgba.data(); // Sky, not background.
    EXPECT_GT(corner[0] + corner[1] + corner[2], 0);
    const std::string programs = run(std::string(kUrn) + " --permutations --skybox " + sky.string()).out;
    EXPECT_NE(programs.find("+sh+reflection"), std::string::npos) << programs;
}

TEST_F(Viewer, SaysWhatAPixelShows) {
    const std::string model = std::string(kUrn) + " --size 80x60 ";
    const Outcome middle = run(model + "--pick 40,30");
    EXPECT_EQ(middle.code, 0) << middle.err;
    for (const char* part : {"node 1: urn\nmaterial 1: porcelain\n", "primitive 0, triangle ", "\npoint "})
        EXPECT_NE(middle.out.find(part), std::string::npos) << middle.out;
    EXPECT_EQ(run(model + "--pick 0,0").out, "nothing\n");
    EXPECT_FALSE(fs::exists(m_folder / "out.png"));
    for (const char* pixel : {"80,0", "0,-1", "7", "a,b"})
        EXPECT_EQ(run(model + "--pick " + pixel).code, 2) << pixel;
    EXPECT_EQ(run(model + "--pick 1,1 --turntable 3").code, 2);
}

TEST_F(Viewer, NumbersTheFramesOfAnAnimation) {
    const std::string model = std::string(kUrn) + " --size 40x30 --frames 2 -o frame_%03d.png ";
    EXPECT_EQ(run(model).code, 2) << "frames are of an animation";
    const Outcome outcome = run(model + "--animation 0");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("no animations"), std::string::npos) << outcome.err;
    EXPECT_EQ(run(model + "--animation 0 --turntable 2").code, 2);
}

TEST_F(Viewer, DrawsFromAllAround) {
    const std::string model = std::string(kUrn) + " --size 40x30 ";
    ASSERT_EQ(run(model + "-o plain.png").code, 0);
    const Outcome outcome = run(model + "--turntable 10 -o round.png");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(fs::exists(m_folder / "round.png"));
    const Picture first = readPicture(m_folder / "round-01.png");
    EXPECT_EQ(compareLit(first, readPicture(m_folder / "plain.png")).max(), 0);
    for (const char* number : {"02", "06", "10"}) {
        const Difference difference =
            compareLit(readPicture(m_folder / ("round-" + std::string(number) + ".png")), first);
        EXPECT_GT(difference.max(), 8) << number;
    }
    EXPECT_FALSE(fs::exists(m_folder / "round-11.png"));
    EXPECT_EQ(run(model + "--turntable 0").code, 2);
    fs::copy_file(kUrn, m_folder / "round-2.png"); // An input is not replaced, whatever it is called.
    EXPECT_EQ(run("round-2.png --turntable 3 -o round.png").code, 2);
}

TEST_F(Viewer, ItsOwnFilesAreNotReplaced) {
    copySnippets();
    fs::copy_file(FRANKEN_SOURCE_DIR "/examples/effects/fog.glsl", m_folder / "fog.glsl");
    fs::copy_file(kUrn, m_folder / "urn.glb");
    for (const char* output : {"urn.glb", "glsl/fragment/ambient/none.glsl", "fog.glsl"}) {
        const Outcome outcome =
            run(std::string("urn.glb --snippets glsl --effect fog.glsl --size 8x8 -o ") + output);
        EXPECT_EQ(outcome.code, 2) << output;
        EXPECT_NE(outcome.err.find("would overwrite"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(readText(m_folder / "fog.glsl"), readText(FRANKEN_SOURCE_DIR "/examples/effects/fog.glsl"));
}

} // namespace
} // namespace franken::test
