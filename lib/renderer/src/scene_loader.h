// SPDX-License-Identifier: MIT
#pragma once

#include "franken/renderer.h"
#include "scene_data.h"

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace franken {

/// Where a scene comes from, and what has changed in it.
struct LoaderInput {
    std::shared_ptr<const Scene> scene; ///< Or null: the source reads it.
    SceneSource source;
    std::map<int, Material> changedMaterials;
    Capabilities capabilities;
};

/// What stays of a scene, with the materials that are others by now.
Outline outlineOf(const Scene& scene, const std::map<int, Material>& changedMaterials);

/// Reads a scene and makes its pieces on a thread of its own, a few ahead of who takes them: no more than
/// kMostWaiting bytes wait, unless one piece alone has more. The destructor waits for the thread.
class SceneLoader {
public:
    static constexpr std::size_t kMostWaiting = std::size_t{32} << 20;

    explicit SceneLoader(LoaderInput input);

    /// Whether take() has an answer. Call it when the piece that was taken last is freed.
    bool isReady();
    /// The next piece, which must not outlive the loader; nothing at the end. Fails as a source does, and as
    /// SceneData.
    Result<std::optional<Piece>> take();
    /// Messages since the last call: a log belongs to the thread of its application.
    std::vector<std::pair<LogLevel, std::string>> takeMessages();
    /// After the end.
    GpuScene takePlan();
    Outline takeOutline();

    /// The thread ends soon, but not at once: after the source, or one image.
    void cancel() { m_thread.request_stop(); }
    bool hasEnded();

private:
    struct Shared {
        std::mutex mutex;
        std::condition_variable_any changed;
        std::deque<Piece> pieces;
        std::size_t waiting = 0, taken = 0; ///< Bytes; `taken`: of these, the piece that was taken last.
        std::vector<std::pair<LogLevel, std::string>> messages;
        Result<void> result;
        bool ended = false;
        GpuScene plan;
        Outline outline;
    };

    void run(const std::stop_token& stop, LoaderInput input);
    Result<void> produce(const std::stop_token& stop, LoaderInput& input);

    std::shared_ptr<const Scene> m_scene; ///< Of the thread. Stays to the end: pieces point to its pixels.
    Shared m_shared;
    std::jthread m_thread; ///< The last member: it uses the others.
};

} // namespace franken
