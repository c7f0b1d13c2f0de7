// SPDX-License-Identifier: MIT
#include "platform/fake_kms.h"

namespace franken::platform {

namespace {

constexpr std::uint64_t kTiled = 0x0700000000000001; ///< A modifier of Broadcom's.

void give(KmsObject& object, std::initializer_list<const char*> names) {
    std::uint32_t id = object.id * 100;
    for (const char* name : names)
        object.properties[name].id = ++id;
}

} // namespace

drm_mode_modeinfo fakeMode(int width, int height, bool preferred) {
    Modeline line{.clock = 0,
                  .width = width,
                  .hsyncStart = width + 1,
                  .hsyncEnd = width + 2,
                  .htotal = width + 100,
                  .height = height,
                  .vsyncStart = height + 1,
                  .vsyncEnd = height + 2,
                  .vtotal = height + 20,
                  .positiveHsync = false,
                  .positiveVsync = false};
    line.clock = line.htotal * line.vtotal * 60 / 1000;
    drm_mode_modeinfo mode = toMode(line);
    mode.type = preferred ? DRM_MODE_TYPE_PREFERRED : 0;
    return mode;
}

FakeKms::FakeKms() {
    KmsConnector connector;
    connector.id = 1;
    connector.name = "HDMI-A-1";
    connector.connection = Connection::Connected;
    connector.modes = {fakeMode(1920, 1080, true), fakeMode(1280, 720, false)};
    connector.possibleCrtcs = 1;
    give(connector, {"CRTC_ID", "Broadcast RGB", "left margin", "right margin", "top margin", "bottom margin",
                     "max bpc", "link-status"});
    connector.properties["Broadcast RGB"].choices = {{"Automatic", 0}, {"Full", 1}, {"Limited 16:235", 2}};
    connector.properties["link-status"].choices = {{"Good", 0}, {"Bad", 1}};
    KmsObject crtc{2, {}};
    give(crtc, {"MODE_ID", "ACTIVE"});
    KmsPlane plane;
    plane.id = 3;
    plane.possibleCrtcs = 1;
    give(plane, {"type", "FB_ID", "CRTC_ID", "SRC_W", "SRC_H", "CRTC_X", "CRTC_Y", "CRTC_W", "CRTC_H"});
    plane.properties["type"].choices = {{"Primary", 1}};
    plane.properties["type"].value = 1;
    plane.formats = {{DRM_FORMAT_XRGB8888, {kTiled, DRM_FORMAT_MOD_LINEAR}},
                     {DRM_FORMAT_RGB565, {DRM_FORMAT_MOD_LINEAR}}};
    resources = {{connector}, {crtc}, {plane}};
}

KmsConnector& FakeKms::addOutput(std::vector<drm_mode_modeinfo> modes) {
    // Ids of properties are those of the first output: objects tell them apart.
    KmsConnector connector = resources.connectors[0];
    connector.id = 11;
    connector.name = "HDMI-A-2";
    connector.modes = std::move(modes);
    connector.possibleCrtcs = 0b10;
    KmsObject crtc = resources.crtcs[0];
    crtc.id = 12;
    KmsPlane plane = resources.planes[0];
    plane.id = 13;
    plane.possibleCrtcs = 0b10;
    resources.crtcs.push_back(crtc);
    resources.planes.push_back(plane);
    return resources.connectors.emplace_back(connector);
}

int FakeKms::commit(const KmsRequest& request, std::uint32_t flags, std::uint64_t frame) {
    if (!master)
        return -EACCES;
    if ((flags & DRM_MODE_ATOMIC_TEST_ONLY) != 0)
        return test(m_tried) != 0 ? test(m_tried) : testRequest(request);
    const int error = errors.empty() ? 0 : errors.front();
    if (!errors.empty())
        errors.pop_front();
    if (error != 0)
        return error;
    if (request.size() <= resources.crtcs.size()) // ACTIVE alone.
        return ++offs, 0;
    ++((flags & DRM_MODE_ATOMIC_ALLOW_MODESET) != 0 ? modesets : flips);
    if ((flags & DRM_MODE_ATOMIC_ALLOW_MODESET) != 0)
        lastModeset = request;
    lastFrame = frame;
    return 0;
}

std::optional<std::uint64_t> FakeKms::wasSet(const KmsObject& object, const std::string& name) const {
    const KmsProperty* property = object.find(name);
    for (const KmsAssignment& set : lastModeset)
        if (property != nullptr && set.object == object.id && set.property == property->id)
            return set.value;
    return std::nullopt;
}

int FakeKms::readFlips(std::vector<KmsFlip>& out) {
    out.assign(answers.begin(), answers.end());
    answers.clear();
    return 0;
}

int FakeKms::addFramebuffer(const KmsBuffer& buffer, std::uint32_t& framebuffer) {
    m_tried = buffer;
    framebuffers.insert(framebuffer = ++m_next);
    return 0;
}

int FakeKms::addBlob(const void*, std::size_t, std::uint32_t& blob) {
    blobs.insert(blob = ++m_next);
    return 0;
}

int FakeBuffers::tryBuffer(Size size, const FormatChoice& format, KmsBuffer& buffer) {
    buffer = {size, format.fourcc,
              format.modifiers.empty() ? DRM_FORMAT_MOD_INVALID : format.modifiers.front()};
    tried.push_back(std::to_string(size.width) + "x" + std::to_string(size.height) + " " +
                    std::string(toString(format.format)) + " " +
                    (format.modifiers.empty()                            ? "none"
                     : format.modifiers.front() == DRM_FORMAT_MOD_LINEAR ? "linear"
                                                                         : "tiled"));
    return 0;
}

} // namespace franken::platform
