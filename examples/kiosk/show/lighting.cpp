// SPDX-License-Identifier: MIT
#include "kiosk/show/lighting.h"

#include "franken/generator/choices.h"
#include "kiosk/config/checks.h"

namespace kiosk {

namespace {

const franken::Sun kDefaultSun{
    .direction = {-0.4f, -0.7f, -0.8f}, .color = {1, 0.98f, 0.95f}, .illuminance = 3};

franken::ToneMap toneMapOf(const std::string& word) {
    for (const franken::Choice& choice : franken::choices())
        if (choice.name == "toneMap")
            for (std::size_t value = 0; value < choice.options.size(); ++value)
                if (choice.options[value].word == word)
                    return static_cast<franken::ToneMap>(value);
    return franken::ToneMap::None;
}

} // namespace

franken::Lighting lightingFor(const franken::Scene& scene, const Config& config, const franken::BakedSky* sky,
                              const LightControls& controls) {
    franken::Lighting lighting;
    for (const std::string& text : config.show.suns)
        lighting.suns.push_back(*parseSun(text));
    if (lighting.suns.empty())
        lighting = franken::lightingOf(scene);
    if (sky != nullptr && sky->sun)
        lighting.suns.push_back(*sky->sun);
    if (sky != nullptr) {
        lighting.ambient = {.kind = franken::Ambient::Sky, .sky = sky->coefficients};
        lighting.reflection = franken::Reflection::Lookup;
    } else {
        lighting.ambient = {.kind = franken::Ambient::Color, .color = *parseColor(config.show.ambient)};
    }
    if (lighting.suns.empty() && lighting.punctualLights.empty() && sky == nullptr)
        lighting.suns.push_back(kDefaultSun);
    if (!controls.suns) {
        lighting.suns.clear();
        lighting.punctualLights.clear();
    }
    lighting.exposure = static_cast<float>(config.show.exposure * controls.exposure);
    return franken::fittedLighting(std::move(lighting));
}

franken::Look lookFor(const Config& config, const std::string& driver, bool isCoarse, bool srgbTarget) {
    franken::Look look{
        .energy = config.show.energy, .toneMap = toneMapOf(config.show.toneMap), .srgbTarget = srgbTarget};
    if (isCoarse)
        look.dither = franken::Dither::Ordered;
    if (driver.find("VC4") != std::string::npos)
        look.target = franken::Target::Vc4;
    return look;
}

} // namespace kiosk
