// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "kiosk/config/config.h"
#include "kiosk/content/loader.h"
#include "kiosk/content/sky.h"
#include "kiosk/report/statistics.h"
#include "kiosk/report/trouble.h"
#include "kiosk/show/canvas.h"
#include "kiosk/show/labels.h"
#include "kiosk/show/lighting.h"
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

    /// Programs that earlier runs needed and that are not there yet, as a share of all.
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

    /// `cover`: 0 shows the model, 1 the background alone. `isLoading`: with a bar that fills as programs are
    /// compiled. `shift`: of texts, in pixels.
    franken::Result<void> draw(double cover, bool isLoading, Shift shift = {});

    /// Adds the programs that were needed to the manifest, if there are new ones. Where that fails, they are
    /// added the next time.
    void keepManifest();

    /// Adds what the renderer knows.
    void report(Statistics& statistics);

    Labels& labels() { return m_labels; }
    franken::Renderer& renderer() { return m_renderer; }
    const franken::DrawTarget& target() const { return m_target; }

private:
    void light();
    franken::Result<void> drawModel();
    franken::Result<void> drawOver(double cover, bool isLoading, Shift shift);
    void warm(const std::vector<franken::ProgramUse>& uses);

    franken::Log m_log;
    std::string m_driver;
    std::filesystem::path m_manifest;
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
    std::vector<franken::ProgramUse> m_warmed, m_unwarmed, m_unwritten;
    std::size_t m_listed = 0; ///< Programs of earlier runs.
    bool m_isLoading = false;
    Trouble m_keeping{"the list of programs is not kept", "the list of programs is kept again"};
    franken::PictureId m_sheet{};
};

} // namespace kiosk
