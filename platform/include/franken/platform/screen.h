// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/platform/rotation.h"
#include "franken/result.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How the KMS backend finds and configures its screen. Nothing here needs a context; listScreens() is for
/// programs that examine a machine.
namespace franken {
namespace FRANKEN_API platform {

/// The format of the screen's buffers.
enum class PixelFormat {
    Rgb8,  ///< 8 bits each of red, green and blue: XR24.
    Rgb10, ///< 10 bits each, XR30, where plane and driver have it; Rgb8 otherwise.
    Rgb565 ///< 5, 6 and 5 bits, RG16: half the memory traffic. Draw with the dither.
};

/// "8888", "10bit" or "565".
std::string_view toString(PixelFormat format);

/// The range of codes that HDMI carries. A screen that expects the other range shows grey or crushed blacks,
/// and every code is shifted.
enum class RgbRange {
    Full,     ///< 0–255, whatever the mode: what monitors want.
    Limited,  ///< 16–235: what some television sets insist on.
    Automatic ///< By CTA-861: limited for television modes, full for others.
};

/// A screen's timing, as `cvt` and `edid-decode` print it; for a screen without EDID.
struct Modeline {
    int clock = 0; ///< Pixel clock in kHz.
    /// Pixels, as the kernel's drm_mode_modeinfo has them.
    int width = 0, hsyncStart = 0, hsyncEnd = 0, htotal = 0;
    /// Lines, likewise.
    int height = 0, vsyncStart = 0, vsyncEnd = 0, vtotal = 0;
    /// Polarity of the synchronisation pulses.
    bool positiveHsync = false, positiveVsync = false;
};

/// From "33.750 800 840 888 976 480 483 493 500 -hsync +vsync" (MHz first; a name in quotes before it is
/// skipped). Fails with `screen.modeline`.
Result<Modeline> parseModeline(std::string_view text);

/// A requested mode: "1280x720", or "1280x720@50" with a refresh rate in Hz.
struct ModeRequest {
    Size size;
    int refresh = 0; ///< Hz; 0 for the highest.
};

/// Fails with `screen.mode`.
Result<ModeRequest> parseModeRequest(std::string_view text);

/// Pixels that stay black at the edges, for a television set that cuts them off.
struct Margins {
    /// Pixels.
    int left = 0, right = 0, top = 0, bottom = 0;
    bool operator==(const Margins&) const = default;
};

/// Which screen is opened, and how.
struct ScreenOptions {
    /// The kernel's name of the connector ("HDMI-A-1", "DSI-1"). Empty: the first connected one; built-in
    /// panels (DSI, DPI, LVDS, eDP) come before plugs (HDMI, DP, DVI, VGA), these before all others;
    /// connectors of the same kind are ordered by name. Where none is connected, a connector of unknown
    /// status that has modes (composite).
    std::string output = {};

    /// A second output of the same device that shows the same picture, in its own shape, on black:
    /// "HDMI-A-2". It is never taken for `output`, may be plugged in and out at any time, and costs no
    /// drawing. A frame is completed when both screens show it, so that the slower one sets the pace.
    std::string mirror = {};

    /// The kernel driver of the node ("vc4"), where two nodes have a connector of that name; empty: any.
    std::string driver = {};

    std::optional<ModeRequest> mode =
        {};            ///< Empty: that of the kernel's command line (video=), or the screen's preferred one.
    int maxExtent = 0; ///< Largest width and height of the buffer; 0: what GL_MAX_TEXTURE_SIZE says.
    int maxPixels = 2560 * 1440; ///< Most pixels of the buffer: 4K is more than a Pi 4 fills.

    PixelFormat format = PixelFormat::Rgb8; ///< Of the buffers that are shown.
    RgbRange range = RgbRange::Full;        ///< Applied where the connector has `Broadcast RGB`.
    Margins margins = {};                   ///< Applied where the connector has them.

    /// Empty: the kernel's `panel orientation`, turned further by `rotate=` on the kernel's command line
    /// (video=DSI-1:…,rotate=90); None where the kernel reports neither.
    std::optional<Rotation> rotation = {};

    bool assumeConnected = false;          ///< Use `output` even if it reports no screen.
    std::optional<Modeline> modeline = {}; ///< The mode for a screen without EDID.

    /// Draw on the CPU where no GPU can be used. Without this option a software driver is refused: Mesa falls
    /// back to it silently if the render node may not be opened, and then draws 2 frames a second.
    bool allowSoftware = false;

    double maxFrameRate = 0; ///< Frames a second at most; 0: the screen's refresh rate.

    /// When a flip is not answered for this long, the screen is switched off and on once; the second time,
    /// the surface becomes SurfaceState::Failed.
    std::chrono::milliseconds flipTimeout{5000};

    std::string devices = "/dev/dri"; ///< Where the nodes are.
};

/// Whether a connector has a screen.
enum class Connection { Connected, Disconnected, Unknown };

/// A connector of a node.
struct ScreenInfo {
    std::string node;   ///< "/dev/dri/card1"; its number means nothing.
    std::string driver; ///< "vc4", "rp1-dsi", …
    std::string output; ///< "HDMI-A-1".
    Connection connection = Connection::Unknown;
    std::string mode;                      ///< The preferred one, "1920x1080@60"; empty without one.
    Rotation orientation = Rotation::None; ///< As the kernel reports its mounting.
};

/// Every connector of every KMS node, in the order in which ScreenOptions::output prefers them. Fails with
/// `screen.no-device` where there is no node, and with `screen.permission` where none may be opened.
Result<std::vector<ScreenInfo>> listScreens(const std::string& devices = "/dev/dri");

} // namespace platform
} // namespace franken
