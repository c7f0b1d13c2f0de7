// SPDX-License-Identifier: MIT
#include "request.h"

namespace franken::platform {

namespace {

/// A driver that lacks the property does without.
void set(KmsRequest& request, const KmsObject& object, const char* name, std::uint64_t value) {
    if (const KmsProperty* property = object.find(name))
        request.push_back({object.id, property->id, value});
}

void setChoice(KmsRequest& request, const KmsObject& object, const char* name, const char* choice) {
    const KmsProperty* property = object.find(name);
    if (property == nullptr)
        return;
    if (const auto found = property->choices.find(choice); found != property->choices.end())
        request.push_back({object.id, property->id, found->second});
}

const char* wordOf(RgbRange range) {
    switch (range) {
    case RgbRange::Full:
        return "Full";
    case RgbRange::Limited:
        return "Limited 16:235";
    case RgbRange::Automatic:
        break;
    }
    return "Automatic";
}

void setConnector(KmsRequest& request, const KmsPipe& pipe, const KmsLayout& layout,
                  const ScreenOptions& options) {
    const KmsConnector& connector = pipe.connector;
    set(request, connector, "CRTC_ID", pipe.crtc.id);
    setChoice(request, connector, "Broadcast RGB", wordOf(options.range));
    const auto margin = [](int pixels) { return static_cast<std::uint64_t>(pixels); };
    set(request, connector, "left margin", margin(options.margins.left));
    set(request, connector, "right margin", margin(options.margins.right));
    set(request, connector, "top margin", margin(options.margins.top));
    set(request, connector, "bottom margin", margin(options.margins.bottom));
    if (layout.format.format == PixelFormat::Rgb10)
        set(request, connector, "max bpc", 10);
}

struct Placement {
    int x, y, width, height;
};

/// The buffer on the screen: as large as it goes in its own shape, in the middle. A buffer that has the
/// screen's shape but for rounding fills it.
Placement placed(Size buffer, Size screen) {
    const auto fitted = [](int extent, int numerator, int denominator, int limit) {
        const auto scaled = static_cast<int>(static_cast<std::int64_t>(extent) * numerator / denominator);
        constexpr int kRounding = 4;
        return limit - scaled <= kRounding ? limit : scaled;
    };
    const int width = fitted(buffer.width, screen.height, buffer.height, screen.width);
    const int height = fitted(buffer.height, screen.width, buffer.width, screen.height);
    return {(screen.width - width) / 2, (screen.height - height) / 2, width, height};
}

void setPlane(KmsRequest& request, const KmsPipe& pipe, const KmsLayout& layout, std::uint32_t framebuffer) {
    const KmsPlane& plane = pipe.plane;
    const Size source = layout.mode.buffer;
    const Placement at = placed(source, {layout.mode.mode.hdisplay, layout.mode.mode.vdisplay});
    const auto whole = [](int pixels) { return static_cast<std::uint64_t>(pixels); };
    const auto fixed = [&](int pixels) { return whole(pixels) << 16; }; // 16.16
    set(request, plane, "FB_ID", framebuffer);
    set(request, plane, "CRTC_ID", pipe.crtc.id);
    set(request, plane, "SRC_X", 0);
    set(request, plane, "SRC_Y", 0);
    set(request, plane, "SRC_W", fixed(source.width));
    set(request, plane, "SRC_H", fixed(source.height));
    set(request, plane, "CRTC_X", whole(at.x));
    set(request, plane, "CRTC_Y", whole(at.y));
    set(request, plane, "CRTC_W", whole(at.width));
    set(request, plane, "CRTC_H", whole(at.height));
}

} // namespace

KmsRequest modesetRequest(const KmsResources& resources, const KmsPipe& pipe, const KmsLayout& layout,
                          std::uint32_t modeBlob, std::uint32_t framebuffer, const ScreenOptions& options) {
    KmsRequest request;
    for (const KmsConnector& other : resources.connectors)
        if (other.id != pipe.connector.id && other.value("CRTC_ID") == pipe.crtc.id)
            set(request, other, "CRTC_ID", 0);
    for (const KmsPlane& other : resources.planes)
        if (other.id != pipe.plane.id && other.value("CRTC_ID") == pipe.crtc.id) {
            set(request, other, "FB_ID", 0);
            set(request, other, "CRTC_ID", 0);
        }
    setConnector(request, pipe, layout, options);
    set(request, pipe.crtc, "MODE_ID", modeBlob);
    set(request, pipe.crtc, "ACTIVE", 1);
    setPlane(request, pipe, layout, framebuffer);
    setChoice(request, pipe.plane, "rotation", "rotate-0");
    return request;
}

KmsRequest flipRequest(const KmsPipe& pipe, const KmsLayout& layout, std::uint32_t framebuffer) {
    KmsRequest request;
    setPlane(request, pipe, layout, framebuffer);
    return request;
}

KmsRequest offRequest(const KmsPipe& pipe) {
    KmsRequest request;
    set(request, pipe.crtc, "ACTIVE", 0);
    return request;
}

void append(KmsRequest& request, const KmsRequest& more) {
    request.insert(request.end(), more.begin(), more.end());
}

} // namespace franken::platform
