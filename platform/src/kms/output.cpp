// SPDX-License-Identifier: MIT
#include "output.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <tuple>

namespace franken::platform {

namespace {

constexpr std::string_view kBuiltIn[] = {"DSI-", "DPI-", "LVDS-", "eDP-"};
constexpr std::string_view kPlugs[] = {"HDMI-", "DP-", "DVI-", "VGA-"};

bool startsWithOne(std::string_view name, const auto& prefixes) {
    return std::any_of(std::begin(prefixes), std::end(prefixes),
                       [&](std::string_view prefix) { return name.starts_with(prefix); });
}

const KmsPlane* primaryPlane(const KmsResources& resources, std::size_t crtc) {
    for (const KmsPlane& plane : resources.planes)
        if ((plane.possibleCrtcs >> crtc & 1u) != 0 && plane.word("type") == "Primary")
            return &plane;
    return nullptr;
}

bool servesAnother(const KmsResources& resources, const KmsObject& crtc, const KmsConnector& connector) {
    return std::any_of(resources.connectors.begin(), resources.connectors.end(),
                       [&](const KmsConnector& other) {
                           return other.id != connector.id && other.value("CRTC_ID") == crtc.id;
                       });
}

/// The degrees in the options of a video= argument, "1280x720@60,rotate=90".
int rotateOf(std::string_view options) {
    constexpr std::string_view kRotate = ",rotate=";
    const std::size_t at = options.find(kRotate);
    int degrees = 0;
    if (at != std::string_view::npos)
        std::from_chars(options.data() + at + kRotate.size(), options.data() + options.size(), degrees);
    return degrees;
}

/// Those for the connector, else those for all.
int commandLineDegrees(std::string_view connector, std::string_view commandLine) {
    constexpr std::string_view kVideo = "video=";
    std::istringstream words{std::string(commandLine)};
    int degrees = 0;
    for (std::string word; words >> word;) {
        if (!word.starts_with(kVideo))
            continue;
        const std::string value = word.substr(kVideo.size());
        const std::size_t colon = value.find(':');
        if (colon == std::string::npos)
            degrees = rotateOf(value);
        else if (value.substr(0, colon) == connector)
            return rotateOf(value);
    }
    return degrees;
}

} // namespace

Rotation mountedRotation(const KmsConnector& connector, std::string_view kernelCommandLine) {
    const Rotation panel =
        rotationOfOrientation(connector.word("panel orientation")).value_or(Rotation::None);
    const int degrees = toDegrees(panel) + commandLineDegrees(connector.name, kernelCommandLine);
    return rotationOf(degrees % 360).value_or(panel);
}

int kindRank(std::string_view connector) {
    if (startsWithOne(connector, kBuiltIn))
        return 0;
    return startsWithOne(connector, kPlugs) ? 1 : 2;
}

bool isUsable(const KmsConnector& connector, const ScreenOptions& options) {
    if (options.assumeConnected && connector.name == options.output)
        return true;
    return !connector.modes.empty() && connector.connection != Connection::Disconnected;
}

const KmsConnector* chooseConnector(const KmsResources& resources, const ScreenOptions& options) {
    const auto order = [](const KmsConnector& connector) {
        return std::tuple(connector.connection == Connection::Unknown, kindRank(connector.name),
                          connector.name);
    };
    const KmsConnector* best = nullptr;
    for (const KmsConnector& connector : resources.connectors) {
        if (connector.name == options.mirror || (!options.output.empty() && connector.name != options.output))
            continue;
        if (isUsable(connector, options) && (best == nullptr || order(connector) < order(*best)))
            best = &connector;
    }
    return best;
}

const KmsConnector* chooseMirror(const KmsResources& resources, const ScreenOptions& options) {
    for (const KmsConnector& connector : resources.connectors)
        if (connector.name == options.mirror && isUsable(connector, options))
            return &connector;
    return nullptr;
}

std::optional<KmsPipe> choosePipe(const KmsResources& resources, const KmsConnector& connector,
                                  std::uint32_t taken) {
    std::optional<KmsPipe> shared;
    for (std::size_t i = 0; i < resources.crtcs.size(); ++i) {
        const KmsPlane* plane = primaryPlane(resources, i);
        if ((connector.possibleCrtcs >> i & 1u) == 0 || plane == nullptr || resources.crtcs[i].id == taken)
            continue;
        const KmsPipe pipe{connector, resources.crtcs[i], *plane};
        if (!servesAnother(resources, pipe.crtc, connector))
            return pipe;
        if (!shared)
            shared = pipe;
    }
    return shared;
}

} // namespace franken::platform
