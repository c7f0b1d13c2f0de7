// SPDX-License-Identifier: MIT
#pragma once

#include "checks.h"
#include "frame.h"
#include "franken/context_check.h"
#include "franken/guard.h"
#include "franken/renderer.h"
#include "franken/saved_state.h"
#include "overlay.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace franken {

/// Programs have no GL object of the renderer's, but are lost and compiled again as all else.
class OwnedPrograms final : public GlOwner {
public:
    explicit OwnedPrograms(Device& device)
        : manager(device.gl, device.capabilities, device.log), m_device(device) {}

    void lost() override { manager.lost(); }
    Result<void> restore() override;

    ProgramManager manager;

private:
    Device& m_device;
};

/// The owners of a renderer's GL objects, and what goes through all of them.
struct [[gnu::visibility("hidden")]] Renderer::State {
    State(const Gl& gl, const Capabilities& capabilities, Log log);

    void lost();
    Result<void> restore(const Gl& gl, const Capabilities& capabilities);

    /// What the context computes in, and has room for, is not the application's to choose.
    void setLook(Look look);
    float anisotropy() const; ///< That the look asks for, and the context has.
    /// Manifests may have been written on another machine.
    std::vector<ProgramUse> asHere(std::span<const ProgramUse> uses) const;
    void sayPrecision() const;

    /// Whether there was anything to evict.
    bool evictOne();

    /// One unit of work: a part of a model's data, or one program.
    Result<void> stepOnce(StepReport & total);

    /// What all functions that call GL do first and last: `function` returns a Result. A context that turns
    /// out to be gone counts as lost from then on.
    template<typename Function>
    auto call(const char* where, Function&& function)->decltype(function()) {
        device.thread.check();
        if (device.isLost)
            return franken::contextLost();
        decltype(function()) result = guarded(where, std::forward<Function>(function));
        if (!result && result.error().code == franken::contextLost().code && !device.isLost)
            lost();
        return result;
    }

    /// What functions do first that return a Result, call no GL and need no context.
    template<typename Function>
    auto note(const char* where, Function&& function)->decltype(function()) {
        device.thread.check();
        return guarded(where, std::forward<Function>(function));
    }

    Device device;
    OwnedPrograms programs{device};
    Models models{device};
    Skybox skybox{device};
    ReflectionTextures reflection{device};
    Pictures pictures{device};
    Overlay overlay{device, programs.manager};
    Frame frame{device, programs.manager, {models, skybox, reflection}};
    const std::array<GlOwner*, 7> owners = {&programs, &models,  &skybox, &reflection,
                                            &pictures, &overlay, &frame};
    std::optional<SavedState> foreign; ///< Between acquireState() and releaseState().
    Result<void> lightingError;        ///< Of the last setLighting().
    std::string saidOfLights;          ///< In the log, so that it is said once.
};

} // namespace franken
