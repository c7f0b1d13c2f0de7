// SPDX-License-Identifier: MIT
#include "checks.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace franken {
namespace {

template<typename Values>
bool areFinite(const Values& values) {
    return std::all_of(std::begin(values), std::end(values), [](auto value) { return std::isfinite(value); });
}

template<typename Vector>
bool isFinite(const Vector& vector) {
    return areFinite(std::span(glm::value_ptr(vector), sizeof(vector) / sizeof(*glm::value_ptr(vector))));
}

bool isAmount(float value) { return std::isfinite(value) && value >= 0; }

constexpr const char* kUnchanged = "pass another value; nothing was changed or drawn";

bool isRotation(const glm::dquat& rotation) {
    const double length = glm::length(rotation);
    return std::isfinite(length) && length > 0;
}

/// The first rule that does not hold, as an error.
struct Rule {
    bool holds;
    const char* where;
    const char* what;
};

/// An element of an array; its text is made for an error alone, because frames are checked, too.
struct Element {
    const char* array;
    std::size_t index;
    std::string text() const { return std::string(array) + "[" + std::to_string(index) + "]"; }
};

Result<void> checkRules(const char* code, std::optional<Element> element, std::initializer_list<Rule> rules) {
    for (const Rule& rule : rules)
        if (!rule.holds)
            return Error{code, (element ? element->text() : "") + rule.where, rule.what, kUnchanged};
    return {};
}

constexpr const char* kAmount = "it must be finite, and 0 or more";

Error lightError(const LightFault& fault, const std::string& light) {
    return {"renderer.lighting", light + "." + std::string(fault.where), std::string(fault.what), kUnchanged};
}

} // namespace

Result<void> check(const Lighting& lighting) {
    for (std::size_t i = 0; i < lighting.suns.size(); ++i)
        if (const auto fault = faultOf(lighting.suns[i]))
            return lightError(*fault, Element{"suns", i}.text());
    for (std::size_t i = 0; i < lighting.punctualLights.size(); ++i)
        if (const auto fault = faultOf(lighting.punctualLights[i]))
            return lightError(*fault, Element{"punctualLights", i}.text());
    if (const auto fault = faultOf(lighting.ambient))
        return lightError(*fault, "ambient");
    return checkRules("renderer.lighting", {},
                      {{isRotation(lighting.skyRotation), "skyRotation", "it must be finite, and not 0"},
                       {isAmount(lighting.exposure), "exposure", kAmount}});
}

Result<void> check(const Viewpoint& viewpoint) {
    constexpr const char* kFinite = "its numbers must be finite";
    return checkRules("renderer.viewpoint", {},
                      {{isFinite(viewpoint.viewProjection), "viewProjection", kFinite},
                       {isFinite(viewpoint.eye), "eye", kFinite},
                       {isFinite(viewpoint.forward), "forward", kFinite},
                       {isFinite(viewpoint.clipToSky), "clipToSky", kFinite}});
}

Result<void> check(const DrawTarget& target) {
    const auto isChannel = [](int bits) { return bits >= 1 && bits <= 16; };
    const auto fits = [](int begin, int size, int whole) {
        return begin >= 0 && size > 0 && begin <= whole && size <= whole - begin;
    };
    const TargetArea area = areaOf(target);
    return checkRules(
        "renderer.target", {},
        {{target.width > 0 && target.height > 0, "width, height", "they must be 1 or more"},
         {fits(area.x, area.width, target.width) && fits(area.y, area.height, target.height), "area",
          "it must lie in the target, and have pixels"},
         {target.clear >= Clear::ColorAndDepth && target.clear <= Clear::Nothing, "clear",
          "there is no such value"},
         {target.backgroundAlpha >= 0 && target.backgroundAlpha <= 1, "backgroundAlpha", "it must be 0 to 1"},
         {target.rotation >= Rotation::None && target.rotation <= Rotation::ThreeQuarters, "rotation",
          "there is no such value"},
         {areFinite(target.background), "background", "it must be finite"},
         {std::all_of(target.bits.begin(), target.bits.end(), isChannel), "bits",
          "each channel must have 1 to 16"}});
}

Result<void> check(std::span<const OverlayQuad> quads) {
    const auto isFiniteRect = [](const OverlayRect& rect) {
        return areFinite(std::array{rect.x, rect.y, rect.width, rect.height});
    };
    for (std::size_t i = 0; i < quads.size(); ++i)
        if (Result<void> checked =
                checkRules("renderer.overlay", Element{"quads", i},
                           {{isFiniteRect(quads[i].place), ".place", "its numbers must be finite"},
                            {isFiniteRect(quads[i].part), ".part", "its numbers must be finite"},
                            {areFinite(quads[i].color), ".color", "its numbers must be finite"}});
            !checked)
            return checked;
    return {};
}

Result<void> check(const Image& image) {
    const bool hasSize = image.width > 0 && image.height > 0;
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const bool isEncoded = image.rgba.empty() && !image.encoded.empty();
    if (hasSize && (isEncoded || (image.rgba.size() / 4 == pixels && image.rgba.size() % 4 == 0)))
        return {};
    return Error{"renderer.image", image.name,
                 hasSize ? "an image of " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                               " has " + std::to_string(image.rgba.size()) + " bytes, not four per pixel"
                         : "an image has no pixels",
                 "fill in width, height, and width * height * 4 bytes"};
}

Result<void> checkTransform(const glm::dmat4& matrix) {
    const glm::dvec4 lastRow = glm::transpose(matrix)[3];
    return checkRules("renderer.transform", {},
                      {{isFinite(matrix), "matrix", "its numbers must be finite"},
                       {lastRow == glm::dvec4(0, 0, 0, 1), "matrix",
                        "its last row must be 0, 0, 0, 1: only a camera projects"}});
}

Result<EffectBlock> effectBlock(std::span<const Float4> values) {
    if (values.size() > kEffectValues)
        return Error{"renderer.effect", "", std::to_string(values.size()) + " values are too many",
                     "an effect has at most " + std::to_string(kEffectValues)};
    EffectBlock block{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!areFinite(values[i]))
            return Error{"renderer.effect", "[" + std::to_string(i) + "]", "it is not finite", kUnchanged};
        block.values[i] = values[i];
    }
    return block;
}

Error unknownModel() {
    return {"renderer.model", "", "there is no such model", "use what add() returned, until remove()"};
}

Error unknownPlace() {
    return {"renderer.place", "", "there is no such place",
            "use what addPlace() or firstPlace() returned, until the place or its model is removed"};
}

Result<void> checkRange(float range) {
    return checkRules("renderer.sky", {}, {{isAmount(range), "range", kAmount}});
}

} // namespace franken
