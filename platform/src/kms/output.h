// SPDX-License-Identifier: MIT
#pragma once

#include "device.h"

#include <optional>

namespace franken::platform {

/// Lower is taken first: built-in panels, plugs, all others.
int kindRank(std::string_view connector);

/// Whether a screen may be shown on it: connected, or unknown with modes, or assumed to be.
bool isUsable(const KmsConnector& connector, const ScreenOptions& options);

/// The connector that the options ask for, or null where there is none to show anything on now. Never the one
/// that mirrors.
const KmsConnector* chooseConnector(const KmsResources& resources, const ScreenOptions& options);

/// The connector that is to mirror, or null where there is none to show anything on now.
const KmsConnector* chooseMirror(const KmsResources& resources, const ScreenOptions& options);

/// How the connector's panel is mounted: as `panel orientation` has it, and turned further by what the
/// kernel's command line says of the connector (video=DSI-1:…,rotate=90), or of all.
Rotation mountedRotation(const KmsConnector& connector, std::string_view kernelCommandLine);

/// The parts of a device that a picture goes through.
struct KmsPipe {
    KmsConnector connector;
    KmsObject crtc;
    KmsPlane plane; ///< The CRTC's primary one.
};

/// A CRTC that the connector can have by its encoders' possible_crtcs (what is attached now says nothing,
/// straight after boot), at best one that serves no other connector, and its primary plane. Never the CRTC
/// `taken`.
std::optional<KmsPipe> choosePipe(const KmsResources& resources, const KmsConnector& connector,
                                  std::uint32_t taken = 0);

} // namespace franken::platform
