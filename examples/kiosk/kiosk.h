// SPDX-License-Identifier: MIT
#pragma once

#include "franken/log.h"
#include "franken/platform/service.h"
#include "franken/platform/surface.h"
#include "kiosk/config/read_config.h"
#include "kiosk/content/content.h"
#include "kiosk/event_loop.h"
#include "kiosk/show/stage.h"
#include "kiosk/show/transition.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace kiosk {

struct RunOptions {
    std::filesystem::path config; ///< Empty: defaults and overrides.
    Overrides overrides;
    std::vector<std::string> models; ///< Of the command line, instead of the playlist.
    franken::platform::Backend backend = franken::platform::Backend::Kms;
};

/// The program: a screen, a stage, and what both wait for.
class Kiosk {
public:
    static franken::Result<std::unique_ptr<Kiosk>> open(RunOptions options, Config config, franken::Log log);
    /// Until it is told to end, or cannot go on.
    franken::Result<void> run();

private:
    Kiosk(RunOptions options, Config config, franken::Log log, std::unique_ptr<EventLoop> loop,
          std::unique_ptr<franken::platform::Surface> surface);

    franken::Result<void> makeStage();
    void surfaceReadable();
    void contentArrived();
    franken::Result<void> frameIfDue();
    franken::Result<void> frame();
    void changeModels();
    void reportState();
    bool wantsFrame() const;

    RunOptions m_options;
    Config m_config;
    franken::Log m_log;
    std::unique_ptr<EventLoop> m_loop;
    std::unique_ptr<franken::platform::Surface> m_surface;
    franken::platform::ServiceManager m_service;
    std::unique_ptr<Content> m_content;
    std::unique_ptr<Stage> m_stage;
    Transition m_transition;
    std::vector<std::unique_ptr<EventLoop::Source>> m_sources;
    std::unique_ptr<EventLoop::Timer> m_frameTimer, m_aliveTimer;
    Time m_lastFrame{0}, m_nextFrame{0};
    bool m_isStale = true; ///< Something changed that the screen does not show yet.
    bool m_ends = false;
    std::string m_state;
};

} // namespace kiosk
