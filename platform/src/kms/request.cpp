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

void setPlane(KmsRequest& request, const KmsPipe& pipe, const KmsLayout& layout, Size source,
              std::uint32_t framebuffer) {
    const KmsPlane& plane = pipe.plane;
    const auto fixed = [](int pixels) { return static_cast<std::uint64_t>(pixels) << 16; }; // 16.16
    set(request, plane, "FB_ID", framebuffer);
    set(request, plane, "CRTC_ID", pipe.crtc.id);
    set(request, plane, "SRC_X", 0);
    set(request, plane, "SRC_Y", 0);
    set(request, plane, "SRC_W", fixed(source.width));
    set(request, plane, "SRC_H", fixed(source.height));
    set(request, plane, "CRTC_X", 0);
    set(request, plane, "CRTC_Y", 0);
    set(request, plane, "CRTC_W", layout.mode.mode.hdisplay);
    set(request, plane, "CRTC_H", layout.mode.mode.vdisplay);
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
    setPlane(request, pipe, layout, layout.mode.buffer, framebuffer);
    setChoice(request, pipe.plane, "rotation", "rotate-0");
    return request;
}

KmsRequest flipRequest(const KmsPipe& pipe, const KmsLayout& layout, Size source, std::uint32_t framebuffer) {
    KmsRequest request;
    setPlane(request, pipe, layout, source, framebuffer);
    return request;
}

KmsRequest offRequest(const KmsPipe& pipe) {
    KmsRequest request;
    set(request, pipe.crtc, "ACTIVE", 0);
    return request;
}

} // namespace franken::platform
