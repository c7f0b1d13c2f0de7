// SPDX-License-Identifier: MIT
#include "renderer_state.h"

#include <algorithm>

namespace franken {

Result<void> OwnedPrograms::restore() {
    manager.restore(m_device.capabilities);
    return {};
}

Renderer::State::State(const Gl& gl, const Capabilities& capabilities, Log log)
    : device(gl, capabilities, std::move(log)) {
    device.memory.setEvict([this] { return evictOne(); });
    setLook({});
    sayPrecision();
}

void Renderer::State::lost() {
    foreign.reset();
    device.lost();
    for (GlOwner* owner : owners)
        owner->lost();
}

Result<void> Renderer::State::restore(const Gl& gl, const Capabilities& capabilities) {
    if (!device.isLost)
        lost();
    device.restore(gl, capabilities);
    setLook(frame.look());
    sayPrecision();
    FirstError first;
    for (GlOwner* owner : owners)
        first.add(owner->restore());
    return first.take();
}

void Renderer::State::setLook(Look look) {
    look.precision = device.capabilities.precision;
    look.joints = device.capabilities.joints;
    frame.setLook(look);
    overlay.forgetProgram();
}

float Renderer::State::anisotropy() const {
    const float asked = frame.look().anisotropy;
    return asked > 1 ? std::min(asked, device.capabilities.maxAnisotropy) : 1; // NaN as well.
}

std::vector<ProgramUse> Renderer::State::asHere(std::span<const ProgramUse> uses) const {
    std::vector<ProgramUse> own(uses.begin(), uses.end());
    for (ProgramUse& use : own) {
        Permutation& permutation = use.permutation;
        permutation.precision = device.capabilities.precision;
        if (!device.capabilities.joints)
            permutation.influences = 0;
        else
            permutation.joints = std::min(permutation.joints, *device.capabilities.joints);
        if (const Result<Canonical> canonical = canonicalise(use.permutation))
            use.permutation = canonical->permutation;
    }
    return own;
}

void Renderer::State::sayPrecision() const {
    if (device.capabilities.precision == Precision::Fp16 && device.log)
        device.log(LogLevel::Info,
                   "fragments compute in 16-bit floats: surfaces are drawn with a roughness of "
                   "0.3 at least");
}

bool Renderer::State::evictOne() {
    GlOwner* oldest = nullptr;
    for (GlOwner* owner : owners)
        if (owner->oldestUse() && (oldest == nullptr || *owner->oldestUse() < *oldest->oldestUse()))
            oldest = owner;
    if (oldest == nullptr)
        return false;
    oldest->evictOldest();
    device.state.invalidate();
    return true;
}

Result<void> Renderer::State::stepOnce(StepReport& total) {
    Result<void> finished;
    if (GpuScene* const scene = models.uploaded()) {
        const unsigned before = programs.manager.counters().links;
        if (!frame.makeProgram(*scene))
            finished = models.finishLoading();
        total.programs += programs.manager.counters().links - before;
        device.state.invalidate();
    } else {
        const Result<std::size_t> bytes = models.step();
        if (!bytes)
            return bytes.error();
        total.bytes += *bytes;
    }
    total.more = models.isLoading();
    return finished;
}

} // namespace franken
