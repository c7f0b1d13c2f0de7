// SPDX-License-Identifier: MIT
#pragma once

#include "support/gltf_builder.h"
#include "viewer_run.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>

namespace franken::test {

using Pixel = std::array<int, 3>;

inline constexpr Pixel kBlack{0, 0, 0}, kGreen{0, 255, 0};
inline constexpr double kPi = std::numbers::pi;

/// The 8-bit code of linear light.
inline int code(double linear) {
    return static_cast<int>(std::lround(
        255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055)));
}

/// A scene in front of an orthographic camera that sees -1 to 1, in the making.
class Model : public GltfBuilder {
public:
    Model() {
        json["extensionsUsed"] = {"KHR_materials_unlit", "KHR_lights_punctual"};
        json["cameras"] = Json::array({camera()});
        addNode({{"camera", 0}, {"translation", {0, 0, 2}}});
    }

    static Json camera() {
        return {{"type", "orthographic"},
                {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}};
    }
    int addNode(const Json& node) {
        const int index = append("nodes", node);
        json["scenes"][0]["nodes"].push_back(index);
        return index;
    }
    int unlit(const std::vector<double>& color) {
        return append("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", color}}},
                                    {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    }
    int lit(double metallic, double roughness, double base = 1) {
        return append("materials", {{"pbrMetallicRoughness",
                                     {{"baseColorFactor", {base, base, base, 1}},
                                      {"metallicFactor", metallic},
                                      {"roughnessFactor", roughness}}}});
    }
    /// A square towards the camera; its mesh.
    int quad(int material, float half = 1) {
        const float h = half;
        return append(
            "meshes",
            {{"primitives",
              {{{"attributes",
                 {{"POSITION", floats("VEC3", {-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0})},
                  {"NORMAL", floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})}}},
                {"indices", accessor("SCALAR", kUShort, std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3})},
                {"material", material}}}}});
    }
    void addSun(double lux) {
        Json& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back({{"type", "directional"}, {"intensity", lux}});
        addNode({{"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    }
};

class ViewerModels : public Viewer {
protected:
    Outcome draw(const std::string& bytes, const std::string& options = "", const char* name = "model.gltf") {
        std::ofstream(m_folder / name, std::ios::binary) << bytes;
        return run(std::string(name) + " --size 64x64 " + options);
    }

    Pixel pixel(int x, int y) const {
        const Picture picture = readPicture(m_folder / "out.png");
        const std::uint8_t* const at = picture.rgba.data() + 4 * (64 * y + x);
        return {at[0], at[1], at[2]};
    }

    /// Draws on both back ends, and looks at each pixel of the list.
    void expect(const Model& model, const std::vector<std::tuple<int, int, Pixel>>& pixels,
                const std::string& options = "", int tolerance = 1) {
        for (const char* backend : {"osmesa", "egl"}) {
            const Outcome outcome = draw(model.bytes(false), options + " --backend " + backend);
            ASSERT_EQ(outcome.code, 0) << outcome.err;
            for (const auto& [x, y, wanted] : pixels)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(pixel(x, y)[channel], wanted[channel], tolerance)
                        << backend << " (" << x << ", " << y << ") " << outcome.err;
        }
    }
};

} // namespace franken::test
