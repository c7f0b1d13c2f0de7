// SPDX-License-Identifier: MIT
#include "setup.h"

#include "franken/displacement.h"
#include "franken/exposure.h"
#include "franken/file.h"
#include "franken/pose.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

using namespace franken;

namespace {

// A map has no more texels than vertices can show: 64 MiB of RGBA at the most.
constexpr std::size_t kMaxHeightMapBytes = std::size_t{64} << 20U;
constexpr int kMaxHeightMapSize = 4096;

// Texels to a pixel, below which a linear filter's blur is seen.
constexpr double kSharpSkybox = 0.75;

std::string camerasOf(const Scene& scene) {
    std::string list;
    for (const Camera& camera : scene.cameras) {
        list += (list.empty() ? "choose one of " : ", ") + std::to_string(camera.index) + " " + camera.name;
        if (!camera.node.empty())
            list += " (node " + camera.node + ")";
    }
    return list.empty() ? "leave the option out: the file has no cameras" : list;
}

void addDefaultLight(Lighting& lighting) {
    lighting.suns.push_back(
        {.direction = {-0.4f, -0.7f, -0.8f}, .color = {1, 0.98f, 0.95f}, .illuminance = 3});
    lighting.ambient = {.kind = Ambient::Color, .color = {0.2f, 0.21f, 0.23f}};
}

/// Index into Scene::animations of the one that the options mean.
Result<int> chosenAnimation(const Scene& scene, const Options& options) {
    const auto isMeant = [&](const Animation& animation) {
        return animation.name == options.animation || std::to_string(animation.index) == options.animation;
    };
    const auto found = std::find_if(scene.animations.begin(), scene.animations.end(), isMeant);
    if (found != scene.animations.end())
        return static_cast<int>(found - scene.animations.begin());
    std::string known;
    for (const Animation& animation : scene.animations)
        known += (known.empty() ? "choose one of " : ", ") + std::to_string(animation.index) + " " +
                 animation.name;
    return Error{"viewer.animation", options.animation, "the file has no such animation",
                 known.empty() ? "leave the option out: the file has no animations" : known};
}

/// Of the picture of that number, counted from 0, of Options::frames.
Result<void> sampleFrame(const Scene& scene, int animation, const Options& options, int number, Pose& pose) {
    const double round = scene.animations[static_cast<std::size_t>(animation)].duration;
    return sample(scene, animation, options.time + round * number / options.frames, pose, Ends::Loop);
}

/// Of all pictures of Options::frames, or of the one where there are no frames. Of many, some are looked at.
Result<Box> boundsOfPictures(const Scene& scene, const Options& options) {
    constexpr int kMost = 60;
    if (options.frames == 0)
        return scene.bounds();
    const Result<int> animation = chosenAnimation(scene, options);
    if (!animation)
        return animation.error();
    Scene moved; // Without images, and what else does not move.
    moved.meshes = scene.meshes;
    moved.instances = scene.instances;
    moved.nodes = scene.nodes;
    moved.skins = scene.skins;
    Box bounds;
    Pose pose;
    for (int number = 0; number < options.frames; number += 1 + options.frames / kMost) {
        if (Result<void> posed = sampleFrame(scene, *animation, options, number, pose).and_then([&] {
                return applyPose(moved, pose);
            });
            !posed)
            return posed.error();
        bounds.add(moved.bounds(), glm::dmat4(1));
    }
    return bounds;
}

} // namespace

Result<Camera> chooseCamera(const Scene& scene, const Options& options) {
    const double aspect = static_cast<double>(options.size.width) / options.size.height;
    if (options.frame || (options.camera.empty() && scene.cameras.empty()))
        return boundsOfPictures(scene, options).transform([aspect](const Box& bounds) {
            return framingCamera(bounds, aspect);
        });
    if (options.camera.empty())
        return scene.cameras.front();
    for (const auto name : {&Camera::name, &Camera::node})
        for (const Camera& camera : scene.cameras)
            if (camera.*name == options.camera)
                return camera;
    int index = kNone;
    const char* const last = options.camera.data() + options.camera.size();
    const auto [end, error] = std::from_chars(options.camera.data(), last, index);
    if (error == std::errc() && end == last)
        for (const Camera& camera : scene.cameras)
            if (camera.index == index)
                return camera;
    return Error{"viewer.camera", options.camera, "the file has no such camera", camerasOf(scene)};
}

Result<void> applyAnimation(Scene& scene, const Options& options) {
    if (options.animation.empty())
        return {};
    Pose pose;
    return chosenAnimation(scene, options)
        .and_then([&](int index) { return sample(scene, index, options.time, pose); })
        .and_then([&] { return applyPose(scene, pose); });
}

Result<void> applyFrame(Scene& scene, Camera& camera, const Options& options, int number) {
    const Result<int> index = chosenAnimation(scene, options);
    if (!index)
        return index.error();
    Pose pose;
    if (Result<void> sampled = sampleFrame(scene, *index, options, number, pose); !sampled)
        return sampled;
    std::vector<NodeWorld> worlds;
    worldsOf(scene, pose, worlds);
    follow(worlds, camera);
    return applyPose(scene, pose);
}

Result<void> applyHeights(Scene& scene, const Options& options) {
    if (options.heightMap.empty())
        return {};
    const auto bytes = readFile(options.heightMap, kMaxHeightMapBytes);
    if (!bytes)
        return bytes.error();
    Result<Image> image = decodeImage(*bytes, kMaxHeightMapSize);
    if (!image)
        return Error{image.error().code, options.heightMap.string(), image.error().what,
                     image.error().remedy};
    return displace(scene, {.image = *std::move(image), .scale = options.heightScale, .ground = 0.5f});
}

Result<Lighting> chooseLighting(const Scene& scene, const BakedSky* sky, const Options& options,
                                const Log& log) {
    Lighting lighting = lightingOf(scene, log);
    lighting.suns.insert(lighting.suns.end(), options.suns.begin(), options.suns.end());
    if (sky && sky->sun)
        lighting.suns.push_back(*sky->sun);
    if (lighting.suns.size() > Permutation::kMaxLights)
        return Error{"viewer.suns", "--sun",
                     std::to_string(lighting.suns.size()) +
                         " suns, those of the file and of the sky included, are too many",
                     "one program takes " + std::to_string(Permutation::kMaxLights)};
    if (sky) {
        lighting.ambient = {.kind = Ambient::Sky, .sky = sky->coefficients};
        lighting.reflection = Reflection::Lookup;
    } else if (options.ambient) {
        lighting.ambient = {.kind = Ambient::Color, .color = *options.ambient};
    }
    const bool dark =
        lighting.suns.empty() && lighting.punctualLights.empty() && lighting.ambient.kind == Ambient::None;
    if (dark)
        addDefaultLight(lighting);
    lighting.exposure =
        options.autoExposure ? autoExposure(lighting, scene.bounds()) : options.exposure.value_or(1.0f);
    return lighting;
}

std::string skyboxNotice(const SkyboxMap& skybox, const Camera& camera, const platform::Size& size) {
    if (skybox.size == 0 || camera.projection == Camera::Projection::Orthographic)
        return {};
    // A face spans two tangents of 45 degrees, and the picture two of half its angle.
    const double needed = static_cast<double>(size.height) / std::tan(0.5 * static_cast<double>(camera.yfov));
    const double texels = skybox.size / needed;
    const int face = static_cast<int>(std::ceil(needed)), most = kMaxSkyWidth / 4;
    if (texels >= kSharpSkybox || skybox.size >= most)
        return {};
    std::array<char, 256> text{};
    std::snprintf(
        text.data(), text.size(),
        "the skybox is magnified: it has %.2f texels to a pixel of the picture; a sky of %d x %d texels, "
        "baked with --skybox-size %d, would be %s",
        texels, 4 * std::min(face, most), 2 * std::min(face, most), std::min(face, most),
        face <= most ? "sharp" : "the sharpest");
    return text.data();
}
