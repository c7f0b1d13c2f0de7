// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"
#include "franken/scene.h"

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace kiosk {

/// A file as it was read.
struct LoadedModel {
    std::filesystem::path path;
    franken::Result<franken::Scene> scene;
    franken::Box swept; ///< What the model passes through as it turns about the middle of its box.
    std::string caption;
    std::vector<std::string> warnings;
};

/// Reads models on a thread of its own, one at a time.
class Loader {
public:
    Loader();
    ~Loader();
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    /// Begins with that file; one that is being read for an earlier request is dropped.
    void request(const std::filesystem::path& path);
    void cancel();

    /// Polls as readable when take() has something.
    int descriptor() const { return m_done; }
    std::optional<LoadedModel> take();

private:
    void run(const std::stop_token& stop);

    int m_done; ///< An eventfd.
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<std::filesystem::path> m_requested;
    std::stop_source m_reading; ///< Of what is being read.
    std::optional<LoadedModel> m_loaded;
    std::jthread m_thread; ///< Last: it uses all of the above.
};

/// The name that a picture of the model carries: the first line of a .txt of the same name beside it, else
/// the file's name, with spaces for hyphens and underscores.
std::string captionOf(const std::filesystem::path& model);

} // namespace kiosk
