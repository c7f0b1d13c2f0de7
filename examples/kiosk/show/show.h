// SPDX-License-Identifier: MIT
#pragma once

#include "franken/platform/surface.h"
#include "kiosk/content/background_reader.h"
#include "kiosk/content/content.h"
#include "kiosk/content/sky.h"
#include "kiosk/control/action.h"
#include "kiosk/decide/relief.h"
#include "kiosk/machine/machine.h"
#include "kiosk/report/statistics.h"
#include "kiosk/report/trouble.h"
#include "kiosk/show/stage.h"
#include "kiosk/show/transition.h"

#include <memory>

namespace kiosk {

/// Reads, uploads, shows and fades one model after the other, and does what visitors ask for.
class Show {
public:
    /// `changed` is called when the picture that the screen shows is out of date.
    Show(EventLoop& loop, const Config& config, Machine machine, franken::Log log,
         EventLoop::Handler changed);

    void configure(const Config& config);

    /// Makes the stage, in the surface's context, which is current.
    franken::Result<void> open(const franken::platform::Surface& surface);
    bool isOpen() const { return m_stage != nullptr; }
    void contextLost();
    void layoutChanged(const franken::platform::Surface& surface);

    /// Whether the picture changes by itself.
    bool moves(Time now) const;
    /// When the picture will next change by itself, after `now`; Time::max(): not by time alone.
    Time nextMove(Time now) const;

    /// Draws a frame that begin() allowed.
    void draw(Time now);

    void act(Action action);
    void drag(double x, double y);
    void zoom(double factor);

    /// Draws fewer pixels, or reads a model only once the one before is gone.
    void relieve(const Relief& relief);

    /// Whether statistics are to be seen: the caller then passes new ones now and then.
    bool showsStatistics() const { return m_statistics; }
    void setStatistics(const Statistics& statistics);

    void report(Statistics& statistics) const;
    Stage* stage() { return m_stage.get(); }

private:
    void skyArrived();
    void contentArrived();
    void wantNext(int direction = 1);
    void change(Time now);
    void label(bool isLoading);
    double loaded();
    void makeRoom(Time now);
    void leaveIfGone();
    void showNothing();
    void requestSky();

    Config m_config;
    Machine m_machine;
    franken::Log m_log;
    EventLoop::Handler m_changed;
    std::unique_ptr<Content> m_content;
    BackgroundReader<franken::Result<Sky>> m_skyReader;
    std::unique_ptr<EventLoop::Source> m_skySource;
    Sky m_sky;
    std::unique_ptr<Stage> m_stage;
    Transition m_transition;
    LightControls m_lights;
    Shift m_shift; ///< Of the texts, in the frame before.
    Trouble m_working{"the next model is not loaded", "models are loaded again"};
    Trouble m_drawing{"the picture is not drawn", "the picture is drawn again"};
    Time m_last{0};                                ///< Of the frame before.
    std::optional<std::filesystem::path> m_before; ///< The model that was shown last; it may be gone.
    int m_direction = 1;                           ///< In which the playlist was searched for the next model.
    bool m_captions, m_statistics;
    double m_resolution = 1;
    double m_loaded = 0; ///< What the bar shows, 0 to 1.
    bool m_paused = false, m_mayPreload = true;
    std::uint64_t m_modelsShown = 0;
};

} // namespace kiosk
