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

/// How the KMS backend finds and sets its screen. Nothing here needs a context: listScreens() is for a
/// program that looks at a machine.
namespace franken {
namespace FRANKEN_API platform {

/// What one pixel of the screen's buffers holds.
enum class PixelFormat {
    Rgb8,  ///< 8 bits each of red, green and blue: XR24.
    Rgb10, ///< 10 bits each, XR30, where plane and driver have it; Rgb8 otherwise.
    Rgb565 ///< 5, 6 and 5 bits, RG16: half the memory traffic. Draw with the dither.
};

/// "8888", "10bit" or "565".
std::string_view toString(PixelFormat format);

/// The range of codes that HDMI carries. A screen that takes one for the other shows grey blacks or crushed
/// ones, and every code is shifted.
enum class RgbRange {
    Full,     ///< 0–255, whatever the mode: what monitors want.
    Limited,  ///< 16–235: what some television sets insist on.
    Automatic ///< By CTA-861: limited for television modes, full for others.
};

/// A screen's timing, as `cvt` and `edid-decode` print it; for a screen without EDID.
struct Modeline {
    int clock = 0; ///< Pixel clock in kHz.
    int width = 0, hsyncStart = 0, hsyncEnd = 0, htotal = 0;
    int height = 0, vsyncStart = 0, vsyncEnd = 0, vtotal = 0;
    bool positiveHsync = false, positiveVsync = false;
};

/// From "33.750 800 840 888 976 480 483 493 500 -hsync +vsync" (MHz first; a name in quotes before it is
/// skipped). Fails with `screen.modeline`.
Result<Modeline> parseModeline(std::string_view text);

/// A mode that is asked for: "1280x720", or "1280x720@50" with a refresh rate in Hz.
struct ModeRequest {
    Size size;
    int refresh = 0; ///< Hz; 0 for the highest.
};

/// Fails with `screen.mode`.
Result<ModeRequest> parseModeRequest(std::string_view text);

/// Pixels that stay black at the edges, for a television set that cuts them off.
struct Margins {
    int left = 0, right = 0, top = 0, bottom = 0;
    bool operator==(const Margins&) const = default;
};

struct ScreenOptions {
    /// The connector's name as the kernel has it ("HDMI-A-1", "DSI-1"). Empty: the first connected one;
    /// built-in panels (DSI, DPI, LVDS, eDP) come before plugs (HDMI, DP, DVI, VGA), these before all others;
    /// of the same kind, by name. Where none is connected, one of unknown status that has modes (composite).
    std::string output = {};

    /// The kernel driver of the node ("vc4"), where two nodes have a connector of that name; empty: any.
    std::string driver = {};

    std::optional<ModeRequest> mode =
        {};            ///< Empty: that of the kernel's command line (video=), or the screen's preferred one.
    int maxExtent = 0; ///< Largest width and height of the buffer; 0: what GL_MAX_TEXTURE_SIZE says.
    int maxPixels = 2560 * 1440; ///< Most pixels of the buffer: 4K is more than a Pi 4 fills.

    PixelFormat format = PixelFormat::Rgb8;
    RgbRange range = RgbRange::Full; ///< Set where the connector has `Broadcast RGB`.
    Margins margins = {};            ///< Set where the connector has them.

    /// Empty: as the kernel says the panel is mounted (`panel orientation`), turned further by the `rotate=`
    /// of its command line (video=DSI-1:…,rotate=90); None where it says neither.
    std::optional<Rotation> rotation = {};

    bool assumeConnected = false;          ///< Take `output` whether or not it says that a screen is there.
    std::optional<Modeline> modeline = {}; ///< The mode then, where EDID has none.

    /// Draw by the processor where no GPU can be used. Without it such a driver is refused: without rights on
    /// the render node Mesa falls back to it silently, at 2 frames a second.
    bool allowSoftware = false;

    double maxFrameRate = 0; ///< Frames a second at most; 0: the screen's refresh rate.

    /// A flip that is not answered for so long has the screen switched off and on once; a second time ends
    /// in SurfaceState::Failed.
    std::chrono::milliseconds flipTimeout{5000};

    std::string devices = "/dev/dri"; ///< Where the nodes are.
};

enum class Connection { Connected, Disconnected, Unknown };

/// A connector of a node.
struct ScreenInfo {
    std::string node;   ///< "/dev/dri/card1"; its number means nothing.
    std::string driver; ///< "vc4", "rp1-dsi", …
    std::string output; ///< "HDMI-A-1".
    Connection connection = Connection::Unknown;
    std::string mode;                      ///< The preferred one, "1920x1080@60"; empty without one.
    Rotation orientation = Rotation::None; ///< As the kernel says that it is mounted.
};

/// Every connector of every KMS node, in the order in which ScreenOptions::output prefers them. Fails with
/// `screen.no-device` where there is no node, and with `screen.permission` where none may be opened.
Result<std::vector<ScreenInfo>> listScreens(const std::string& devices = "/dev/dri");

} // namespace platform
} // namespace franken
