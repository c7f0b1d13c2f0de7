// SPDX-License-Identifier: MIT
// What a screen is set to: its mode, format and turn, and those of the screen that mirrors it.
#include "screen.h"

#include "commit_error.h"

#include <cstring>
#include <utility>

namespace franken::platform {

namespace {

constexpr std::uint32_t kTest = kModeset | DRM_MODE_ATOMIC_TEST_ONLY;

bool sameMode(const drm_mode_modeinfo& a, const drm_mode_modeinfo& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// The kernel gave the signal up, and asks for a modeset.
bool isLinkBad(const KmsConnector& connector) { return connector.word("link-status") == "Bad"; }

bool sameLayout(const KmsLayout& a, const KmsLayout& b) {
    return sameMode(a.mode.mode, b.mode.mode) && a.mode.buffer == b.mode.buffer &&
           a.format.fourcc == b.format.fourcc && a.format.modifiers == b.format.modifiers &&
           a.rotation == b.rotation;
}

bool sameMirror(const std::optional<KmsMirror>& a, const std::optional<KmsMirror>& b) {
    if (!a || !b)
        return !a && !b;
    return a->pipe.connector.id == b->pipe.connector.id && a->pipe.crtc.id == b->pipe.crtc.id &&
           sameLayout(a->layout, b->layout);
}

} // namespace

void KmsScreen::configure(Nanoseconds now) {
    if (!m_device.isMaster() && m_device.setMaster() != 0)
        return waitForMaster(now);
    m_updateWanted = false;
    if (const int error = m_device.readResources(m_resources, ~0u); error != 0)
        return refused(error, now);
    const KmsConnector* connector = chooseConnector(m_resources, m_options);
    std::optional<KmsPipe> pipe = connector == nullptr ? std::nullopt : choosePipe(m_resources, *connector);
    if (!pipe) {
        m_pipe.reset();
        adoptMirror(std::nullopt);
        m_needsModeset = true;
        m_deadline.reset();
        m_applied = Blanking::None;
        const std::string name = m_options.output.empty() ? "any output" : m_options.output;
        return enter(SurfaceState::NoScreen, connector == nullptr
                                                 ? "no screen is connected to " + name
                                                 : connector->name + ": no CRTC is free for it");
    }
    if (!m_pipe || m_pipe->connector.id != pipe->connector.id) {
        m_step = 0;
        m_needsModeset = true; // Another output shows nothing yet, although its layout may be the same.
    }
    if (isLinkBad(pipe->connector))
        m_needsModeset = true;
    if (!chooseLayout(m_resources, *pipe, now))
        return;
    m_pipe = std::move(pipe);
    m_applied = m_needsModeset ? Blanking::None : m_applied;
    m_deadline.reset();
    if (m_blanking != m_applied)
        return applyBlanking(now);
    if (m_applied != Blanking::None)
        return;
    if (m_waiting == 0)
        return readyOrHeld(now);
    m_deadline = now + period(); // tick() shows it: whoever drew it takes it for shown.
    enter(SurfaceState::Busy, sentence());
}

bool KmsScreen::chooseLayout(const KmsResources& resources, const KmsPipe& pipe, Nanoseconds now) {
    const std::vector<ModeChoice> modes = modeChoices(pipe.connector, m_options, m_maxExtent);
    const std::vector<FormatChoice> formats = formatChoices(pipe.plane, m_options.format);
    const Rotation rotation =
        m_options.rotation.value_or(mountedRotation(pipe.connector, m_device.kernelCommandLine()));
    for (; m_step < modes.size() * formats.size(); ++m_step) {
        const KmsLayout layout{modes[m_step / formats.size()], formats[m_step % formats.size()], rotation};
        KmsBuffer buffer;
        const int error = tryLayout(resources, pipe, layout, buffer);
        if (error == 0)
            return adopt(pipe, layout, buffer);
        const CommitAction action = actionFor(error);
        if (action == CommitAction::WaitForMaster || action == CommitAction::WaitForDevice)
            return refused(error, now), false;
    }
    fail({"screen.no-layout", pipe.connector.name, "the driver refuses every mode and format",
          "name another output or mode, or give a modeline"});
    return false;
}

int KmsScreen::tryLayout(const KmsResources& resources, const KmsPipe& pipe, const KmsLayout& layout,
                         KmsBuffer& buffer) {
    if (const int error = m_buffers.tryBuffer(layout.mode.buffer, layout.format, buffer); error != 0)
        return error;
    std::uint32_t framebuffer = 0, blob = 0;
    if (const int error = m_device.addFramebuffer(buffer, framebuffer); error != 0)
        return error;
    int error = m_device.addBlob(&layout.mode.mode, sizeof layout.mode.mode, blob);
    if (error == 0) {
        const KmsRequest request = modesetRequest(resources, pipe, layout, blob, framebuffer, m_options);
        error = m_device.commit(request, kTest, 0);
        if (error == 0)
            adoptMirror(findMirror(resources, pipe, layout, request, framebuffer));
        m_device.removeBlob(blob);
    }
    m_device.removeFramebuffer(framebuffer);
    return error;
}

bool KmsScreen::adopt(const KmsPipe& pipe, const KmsLayout& layout, const KmsBuffer& buffer) {
    if (m_modeBlob != 0 && sameLayout(layout, m_layout))
        return true;
    if (m_modeBlob != 0)
        m_device.removeBlob(std::exchange(m_modeBlob, 0));
    if (m_device.addBlob(&layout.mode.mode, sizeof layout.mode.mode, m_modeBlob) != 0)
        m_modeBlob = 0;
    m_shown = m_waiting = 0;
    m_needsModeset = true;
    m_last.reset();
    m_layout = layout;
    ++m_layoutCount;
    if (Result<void> made = m_buffers.makeTarget(buffer, layout.format.format); !made) {
        Error error = made.error();
        error.where = pipe.connector.name + ": " + error.where;
        return fail(std::move(error)), false;
    }
    return true;
}

std::optional<KmsMirror> KmsScreen::findMirror(const KmsResources& resources, const KmsPipe& pipe,
                                               const KmsLayout& layout, const KmsRequest& request,
                                               std::uint32_t framebuffer) {
    if (m_options.mirror.empty() || m_mirrorRefused)
        return std::nullopt;
    m_mirrorLack.clear();
    const KmsConnector* connector = chooseMirror(resources, m_options);
    const std::optional<KmsPipe> second =
        connector == nullptr ? std::nullopt : choosePipe(resources, *connector, pipe.crtc.id);
    if (!second) {
        m_mirrorLack = connector == nullptr ? "no screen is connected" : "no CRTC is free for it";
        return std::nullopt;
    }
    const int refresh = refreshMilliHertz(layout.mode.mode);
    for (const ModeChoice& mode : mirrorChoices(*connector, layout.mode.buffer, refresh)) {
        KmsMirror mirror{*second, {mode, layout.format, layout.rotation}, 0};
        if (m_device.addBlob(&mode.mode, sizeof mode.mode, mirror.modeBlob) != 0)
            break;
        KmsRequest both = request;
        append(both, modesetRequest(resources, mirror.pipe, mirror.layout, mirror.modeBlob, framebuffer,
                                    m_mirrorOptions));
        if (m_device.commit(both, kTest, 0) == 0)
            return mirror;
        m_device.removeBlob(mirror.modeBlob);
    }
    m_mirrorLack = "the driver refuses every mode";
    return std::nullopt;
}

void KmsScreen::adoptMirror(std::optional<KmsMirror> mirror) {
    if (mirror && isLinkBad(mirror->pipe.connector))
        m_needsModeset = true;
    std::optional<KmsMirror>& unused = sameMirror(mirror, m_mirror) ? mirror : m_mirror;
    if (unused)
        m_device.removeBlob(unused->modeBlob);
    if (&unused == &mirror)
        return;
    if (m_mirror && (!mirror || mirror->pipe.crtc.id != m_mirror->pipe.crtc.id))
        m_device.commit(offRequest(m_mirror->pipe), kModeset | kNonblocking, 0);
    m_mirror = std::move(mirror);
    m_needsModeset = true;
}

bool KmsScreen::giveUpMirror() {
    if (!m_mirror)
        return false;
    m_mirrorRefused = true;
    m_mirrorLack = "the driver refuses it";
    adoptMirror(std::nullopt);
    return true;
}

KmsRequest KmsScreen::modesetOf(std::uint32_t framebuffer) const {
    KmsRequest request = modesetRequest(m_resources, *m_pipe, m_layout, m_modeBlob, framebuffer, m_options);
    if (m_mirror)
        append(request, modesetRequest(m_resources, m_mirror->pipe, m_mirror->layout, m_mirror->modeBlob,
                                       framebuffer, m_mirrorOptions));
    return request;
}

KmsRequest KmsScreen::flipOf(std::uint32_t framebuffer) const {
    KmsRequest request = flipRequest(*m_pipe, m_layout, framebuffer);
    if (m_mirror)
        append(request, flipRequest(m_mirror->pipe, m_mirror->layout, framebuffer));
    return request;
}

KmsRequest KmsScreen::offOf() const {
    KmsRequest request = offRequest(*m_pipe);
    if (m_mirror)
        append(request, offRequest(m_mirror->pipe));
    return request;
}

void KmsScreen::switchOff() {
    m_device.commit(offOf(), kModeset | kNonblocking, 0);
    m_needsModeset = true;
}

std::string KmsScreen::sentence() const {
    const ModeChoice& mode = m_layout.mode;
    std::string text = m_pipe->connector.name + " " + describe(mode.mode) + " " +
                       std::string(toString(m_layout.format.format));
    if (mode.scaled())
        text += ", drawn at " + std::to_string(mode.buffer.width) + "x" + std::to_string(mode.buffer.height);
    if (m_layout.rotation != Rotation::None)
        text += ", turned by " + std::to_string(toDegrees(m_layout.rotation));
    if (m_mirror)
        text += ", mirrored on " + m_mirror->pipe.connector.name + " " + describe(m_mirror->layout.mode.mode);
    else if (!m_mirrorLack.empty())
        text += ", not mirrored on " + m_options.mirror + " (" + m_mirrorLack + ")";
    return text;
}

} // namespace franken::platform
