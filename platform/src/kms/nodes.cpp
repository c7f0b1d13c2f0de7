// SPDX-License-Identifier: MIT
#include "nodes.h"

#include "mode.h"
#include "output.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <tuple>

namespace franken::platform {

namespace fs = std::filesystem;

namespace {

/// Paths of the nodes that may set modes ("card0"), in the order of their names.
std::vector<std::string> nodesIn(const std::string& folder) {
    std::vector<std::string> nodes;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->path().filename().string().starts_with("card"))
            nodes.push_back(at->path());
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

struct Opened {
    std::unique_ptr<KmsDevice> device;
    KmsResources resources;
};

/// All that set modes. Fails with `screen.permission` where none could be opened for want of rights.
Result<std::vector<Opened>> openAll(const std::string& folder) {
    std::vector<Opened> all;
    std::optional<Error> refused;
    for (const std::string& node : nodesIn(folder)) {
        Result<std::unique_ptr<KmsDevice>> device = openKmsDevice(node);
        if (!device) {
            if (device.error().code == "screen.permission")
                refused = device.error();
            continue;
        }
        Opened& opened = all.emplace_back(Opened{*std::move(device), {}});
        if (opened.device->readResources(opened.resources, ~0u) != 0)
            all.pop_back();
    }
    if (all.empty() && refused)
        return *refused;
    return all;
}

/// Lower is better. Nothing where it has no such output.
std::optional<std::tuple<int, int, std::string>> rankOf(const Opened& opened, const ScreenOptions& options) {
    if (!options.driver.empty() && opened.device->driver() != options.driver)
        return std::nullopt;
    if (const KmsConnector* connector = chooseConnector(opened.resources, options))
        return std::tuple(connector->connection == Connection::Unknown ? 1 : 0, kindRank(connector->name),
                          connector->name);
    for (const KmsConnector& connector : opened.resources.connectors)
        if (options.output.empty() || connector.name == options.output)
            return std::tuple(2, 0, connector.name);
    return std::nullopt;
}

bool holds(const fs::path& process, const fs::path& node) {
    std::error_code error;
    for (fs::directory_iterator at(process / "fd", error), end; !error && at != end; at.increment(error))
        if (std::error_code ignored; fs::read_symlink(at->path(), ignored) == node)
            return true;
    return false;
}

std::string preferredMode(const KmsConnector& connector) {
    const auto preferred =
        std::find_if(connector.modes.begin(), connector.modes.end(), [](const drm_mode_modeinfo& mode) {
            return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0;
        });
    if (preferred != connector.modes.end())
        return describe(*preferred);
    return connector.modes.empty() ? "" : describe(connector.modes.front());
}

} // namespace

Result<std::unique_ptr<KmsDevice>> findKmsDevice(const ScreenOptions& options) {
    Result<std::vector<Opened>> all = openAll(options.devices);
    if (!all)
        return all.error();
    std::optional<std::tuple<int, int, std::string>> best;
    std::unique_ptr<KmsDevice> found;
    for (Opened& opened : *all)
        if (const auto rank = rankOf(opened, options); rank && (!best || *rank < *best)) {
            best = rank;
            found = std::move(opened.device);
        }
    return found;
}

std::string holdersOf(const std::string& node) {
    std::string holders;
    std::error_code error;
    const std::string self = std::to_string(getpid());
    for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
        const std::string process = at->path().filename();
        if (process.find_first_not_of("0123456789") != std::string::npos || process == self ||
            !holds(at->path(), node))
            continue;
        std::string name;
        std::getline(std::ifstream(at->path() / "comm"), name);
        holders.append(holders.empty() ? "" : ", ")
            .append(name)
            .append(" (process ")
            .append(process)
            .append(")");
    }
    return holders;
}

Result<std::vector<ScreenInfo>> listScreens(const std::string& devices) {
    Result<std::vector<Opened>> all = openAll(devices);
    if (!all)
        return all.error();
    if (all->empty())
        return Error{"screen.no-device", devices, "there is no node that drives a screen",
                     "load the KMS driver (dtoverlay=vc4-kms-v3d)"};
    std::vector<ScreenInfo> screens;
    for (const Opened& opened : *all)
        for (const KmsConnector& connector : opened.resources.connectors)
            screens.push_back({opened.device->node(), opened.device->driver(), connector.name,
                               connector.connection, preferredMode(connector),
                               mountedRotation(connector, opened.device->kernelCommandLine())});
    std::stable_sort(screens.begin(), screens.end(), [](const ScreenInfo& a, const ScreenInfo& b) {
        const auto order = [](const ScreenInfo& screen) {
            return std::tuple(screen.connection == Connection::Disconnected,
                              screen.connection == Connection::Unknown, kindRank(screen.output),
                              screen.output);
        };
        return order(a) < order(b);
    });
    return screens;
}

} // namespace franken::platform
