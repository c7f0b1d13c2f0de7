// SPDX-License-Identifier: MIT
#pragma once

#include "kms/screen.h"

#include <cerrno>
#include <deque>
#include <set>

namespace franken::platform {

/// A device with one connector, HDMI-A-1, a CRTC and a primary plane; with another of each after addOutput().
/// Commits are written down; errors can be
/// put in their way; flips are answered when the test says so.
class FakeKms final : public KmsDevice {
public:
    FakeKms();
    /// A screen with these modes on HDMI-A-2, with a CRTC and a plane of its own.
    KmsConnector& addOutput(std::vector<drm_mode_modeinfo> modes);

    /// What the next commits that are no TEST_ONLY return, in turn; 0 after them.
    std::deque<int> errors;
    /// Whether a TEST_ONLY commit is refused: asked for the tried buffer.
    std::function<int(const KmsBuffer&)> test = [](const KmsBuffer&) { return 0; };

    KmsResources resources;
    bool master = true, masterIsFree = true;
    int modesets = 0, flips = 0, offs = 0;
    std::set<std::uint32_t> framebuffers, blobs;
    std::uint64_t lastFrame = 0;
    KmsRequest lastModeset;
    /// Whether a TEST_ONLY commit is refused: asked for all that it sets.
    std::function<int(const KmsRequest&)> testRequest = [](const KmsRequest&) { return 0; };
    /// What the last modeset set the property of an object to; nothing where it did not set it.
    std::optional<std::uint64_t> wasSet(const KmsObject& object, const std::string& name) const;
    std::deque<KmsFlip> answers;
    void answer(std::uint32_t sequence, Nanoseconds time, std::uint32_t crtc = 2) {
        answers.push_back({lastFrame, sequence, time, crtc});
    }

    int descriptor() const override { return -1; }
    std::string node() const override { return "/dev/dri/card7"; }
    std::string driver() const override { return "fake"; }
    std::string commandLine;
    std::string kernelCommandLine() const override { return commandLine; }
    int readResources(KmsResources& out, std::uint32_t) override { return out = resources, 0; }
    int commit(const KmsRequest& request, std::uint32_t flags, std::uint64_t frame) override;
    int readFlips(std::vector<KmsFlip>& out) override;
    int addFramebuffer(const KmsBuffer& buffer, std::uint32_t& framebuffer) override;
    void removeFramebuffer(std::uint32_t framebuffer) override { framebuffers.erase(framebuffer); }
    int addBlack(Size, std::uint32_t& framebuffer) override { return framebuffer = 99, 0; }
    void removeBlack() override {}
    int addBlob(const void*, std::size_t, std::uint32_t& blob) override;
    void removeBlob(std::uint32_t blob) override { blobs.erase(blob); }
    bool isMaster() override { return master; }
    int setMaster() override { return masterIsFree ? (master = true, 0) : -EBUSY; }
    int dropMaster() override { return master = false, 0; }

private:
    std::uint32_t m_next = 100;
    KmsBuffer m_tried;
};

/// Buffers without memory; keeps book of what was tried and released.
class FakeBuffers final : public KmsBuffers {
public:
    std::vector<std::string> tried;
    int targets = 0;
    std::vector<std::uint32_t> released;

    int tryBuffer(Size size, const FormatChoice& format, KmsBuffer& buffer) override;
    Result<void> makeTarget(const KmsBuffer&, PixelFormat) override { return ++targets, Result<void>(); }
    void release(std::uint32_t framebuffer) override { released.push_back(framebuffer); }
};

drm_mode_modeinfo fakeMode(int width, int height, bool preferred);

} // namespace franken::platform
