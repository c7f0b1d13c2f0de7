// SPDX-License-Identifier: MIT
#include "changes.h"

#include <algorithm>
#include <utility>

using namespace franken;

namespace price {
namespace {

class Offers {
public:
    explicit Offers(const Terms& terms) : m_terms(terms) {}

    /// With a member of the look at that value, if it has another.
    template<typename Value>
    void add(const char* words, Value Look::*member, Value value) {
        if (m_terms.look.*member == value)
            return;
        Terms changed = m_terms;
        changed.look.*member = value;
        m_offers.push_back({words, std::move(changed)});
    }

    void add(std::string words, Terms changed) { m_offers.push_back({std::move(words), std::move(changed)}); }

    std::vector<Offer> take() { return std::move(m_offers); }

private:
    const Terms& m_terms;
    std::vector<Offer> m_offers;
};

void addFewerLights(const Terms& terms, Offers& offers) {
    const Lighting fitted = fittedLighting(terms.lighting);
    if (!fitted.suns.empty()) {
        Terms changed = terms;
        changed.lighting = fitted;
        changed.lighting.suns.pop_back();
        offers.add("one sun less", std::move(changed));
    }
    if (!fitted.punctualLights.empty()) {
        Terms changed = terms;
        changed.lighting = fitted;
        changed.lighting.punctualLights.pop_back();
        offers.add("one point or spot light less", std::move(changed));
    }
}

} // namespace

std::vector<Offer> offersFor(const Terms& terms) {
    Offers offers(terms);
    offers.add("--light-vectors vertex", &Look::lightVectors, LightVectors::PerVertex);
    offers.add("--tone-map clip", &Look::toneMap, ToneMap::None);
    if (terms.look.toneMap == ToneMap::Aces || terms.look.toneMap == ToneMap::Neutral)
        offers.add("--tone-map reinhard", &Look::toneMap, ToneMap::Reinhard);
    offers.add("--decode fast", &Look::decode, Decode::Fast);
    if (terms.look.output == Output::Srgb)
        offers.add("--output srgb-fast", &Look::output, Output::SrgbFast);
    offers.add("--brdf fast", &Look::brdf, Brdf::Fast);
    offers.add("--brdf schlick", &Look::brdf, Brdf::Schlick);
    offers.add("no --energy", &Look::energy, false);
    offers.add("--dither no-dither", &Look::dither, Dither::None);
    addFewerLights(terms, offers);
    Terms halved = terms;
    halved.halvedTextures = true;
    offers.add("textures of half the width and height", std::move(halved));
    return offers.take();
}

} // namespace price
