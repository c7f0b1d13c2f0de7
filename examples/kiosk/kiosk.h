// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/platform/console.h"
#include "franken/platform/service.h"
#include "franken/platform/surface.h"
#include "franken/platform/watch.h"
#include "kiosk/config/file_watch.h"
#include "kiosk/config/read_config.h"
#include "kiosk/control/controls.h"
#include "kiosk/decide/opening.h"
#include "kiosk/decide/pace.h"
#include "kiosk/event_loop.h"
#include "kiosk/machine/monitor.h"
#include "kiosk/report/screenshot.h"
#include "kiosk/report/trouble.h"
#include "kiosk/show/show.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace kiosk {

struct RunOptions {
    std::filesystem::path config; ///< Empty: defaults and overrides.
    Overrides overrides;
    std::vector<std::string> models; ///< Of the command line, instead of the playlist.
    franken::platform::Backend backend = franken::platform::Backend::Kms;
    std::filesystem::path root = "/"; ///< Where /sys and /proc are.
};

/// The configuration of a file and of options; with what is wrong with them.
ReadConfig configOf(const RunOptions& options);

/// The program: a screen, a show, and what both wait for.
class Kiosk {
public:
    static franken::Result<std::unique_ptr<Kiosk>> open(RunOptions options, Config config, franken::Log log);
    /// Returns when the kiosk is told to end, or cannot go on.
    franken::Result<void> run();

private:
    Kiosk(RunOptions options, Config config, franken::Log log, std::unique_ptr<EventLoop> loop,
          std::unique_ptr<franken::platform::Surface> surface);

    void listen();
    Controls::Handlers handlers();
    void openConsole();

    void surfaceReadable();
    void consoleReadable();
    void reload();
    void act(Action action);

    void followClock();
    franken::Result<void> frameIfDue();
    franken::Result<void> frame();
    void checkGpu();
    bool canHold() const;
    void noteCopies();
    void givePicture(const PictureSource& picture);
    franken::Result<void> obeyWatch();
    void beat(const PictureSource& picture);
    Time nextByTime() const;
    void reportState();

    RunOptions m_options;
    Config m_config;
    franken::Log m_log;
    std::unique_ptr<EventLoop> m_loop;
    std::unique_ptr<franken::platform::Surface> m_surface;
    std::unique_ptr<franken::platform::Console> m_console;
    franken::platform::ServiceManager m_service;
    franken::platform::Watch m_watch;
    std::unique_ptr<franken::platform::GpuHealth> m_health;
    std::unique_ptr<Show> m_show;
    std::unique_ptr<Controls> m_controls;
    std::unique_ptr<Monitor> m_monitor;
    std::unique_ptr<FileWatch> m_fileWatch;
    Screenshots m_screenshots;
    Opening m_opening;
    std::string m_dark; ///< Why the screen is; empty: it is not.
    FrameTimes m_frameTimes;
    Pace m_pace;

    std::vector<std::unique_ptr<EventLoop::Source>> m_sources;
    std::unique_ptr<EventLoop::Timer> m_frameTimer, m_clockTimer, m_aliveTimer;
    Time m_started, m_frameWork{0}, m_lastFrame{0}, m_nextHeartbeat{0}, m_nextStatistics{0};
    Trouble m_beating{"no heartbeat", "the heartbeat is written again"};
    std::string m_state;
    bool m_isStale = true; ///< Something changed that the screen does not show yet.
    bool m_wantsScreenshot = false, m_ends = false;
    bool m_takesScreenshot = false, m_beats = false; ///< With the frame that is on its way.
    BackgroundTask m_beat;                           ///< Last: it uses what is above.
};

} // namespace kiosk
