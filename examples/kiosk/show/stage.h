// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "kiosk/config/config.h"
#include "kiosk/content/loader.h"
#include "kiosk/content/sky.h"
#include "kiosk/report/statistics.h"
#include "kiosk/show/canvas.h"
#include "kiosk/show/labels.h"
#include "kiosk/show/lighting.h"
#include "kiosk/show/program_list.h"
#include "kiosk/show/view.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace kiosk {

/// A model that is on the GPU, or on its way there.
struct Exhibit {
    std::filesystem::path path;
    std::string caption;
    franken::ModelId id{};
    franken::PlaceId place{};
    View view;
    std::vector<franken::ProgramUse> uses;
};

/// Draws the model that is shown, and a sheet of background over it in a fade; uploads the next model and
/// warms its programs up in steps.
class Stage {
public:
    /// `manifest`: where the programs of earlier runs are listed; empty for none.
    Stage(const franken::Gl& gl, const std::string& driver, std::filesystem::path manifest,
          const Config& config, franken::Log log);

    /// The context is lost, with all that was in it. Only the destructor may be called after that.
    void contextLost();

    /// Takes over the settings that may change while the kiosk runs.
    void configure(const Config& config);
    void setSky(Sky sky);
    void setControls(const LightControls& controls);
    void setTarget(const franken::DrawTarget& target, bool srgbTarget);

    /// Of width and height, above 0 to 1: fewer pixels are drawn, and stretched.
    void setResolution(double share) { m_resolution = share; }

    /// The share of the programs that are known to be needed, by earlier runs and by the next model, that is
    /// there, 0 to 1.
    double warmedUp() const;

    /// Begins to upload the next model; drops the one that was next before.
    franken::Result<void> prepare(LoadedModel model);
    void dropNext();
    bool hasNext() const { return m_next != nullptr; }
    /// Whether the next model can be shown without work left to do. Fails as its upload did; it is dropped
    /// then.
    franken::Result<bool> nextIsReady();
    /// Shows the next model, and removes the shown one.
    franken::Result<void> change();
    /// Shows nothing.
    void clear();

    Exhibit* shown() { return m_shown.get(); }
    Exhibit* next() { return m_next.get(); }

    /// A step of what is left to upload and compile. Call it between begin() of a frame and draw(), because
    /// it draws to the target.
    franken::Result<void> work();
    bool hasWork() const { return m_isLoading || !m_unwarmed.empty(); }

    /// `cover`: 0 shows the model, 1 the background alone. `loaded`: how far a bar is filled, 0 to 1; empty,
    /// there is none. `shift`: of texts, in pixels.
    franken::Result<void> draw(double cover, std::optional<double> loaded, Shift shift = {});

    /// Adds the programs that were needed to their list, if there are new ones; waits for no disk. Where that
    /// fails, they are added the next time, or by the destructor.
    void keepPrograms();

    /// Adds what the renderer knows.
    void report(Statistics& statistics);

    Labels& labels() { return m_labels; }
    franken::Renderer& renderer() { return m_renderer; }
    const franken::DrawTarget& target() const { return m_target; }

private:
    void light();
    franken::Result<void> drawModel();
    franken::Result<void> drawOver(double cover, std::optional<double> loaded, Shift shift);
    void warm(const std::vector<franken::ProgramUse>& uses);

    franken::Log m_log;
    std::string m_driver;
    ProgramList m_programs;
    Config m_config;
    franken::Renderer m_renderer;
    Canvas m_canvas;
    Labels m_labels;
    double m_resolution = 1;
    franken::DrawTarget m_target;
    bool m_srgbTarget = false;
    franken::Look m_look;
    LightControls m_controls;
    Sky m_sky;
    std::unique_ptr<Exhibit> m_shown, m_next;
    std::vector<franken::ProgramUse> m_warmed, m_unwarmed;
    bool m_isLoading = false;
    franken::PictureId m_sheet{};
};

} // namespace kiosk
