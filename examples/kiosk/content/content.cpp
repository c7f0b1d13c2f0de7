// SPDX-License-Identifier: MIT
#include "kiosk/content/content.h"

#include "franken/printable.h"

#include <algorithm>

namespace kiosk {

namespace fs = std::filesystem;
using franken::LogLevel;

namespace {

constexpr Time kLookAgain = std::chrono::seconds(5);

/// Whether a model is read from that file, too: its caption, or a buffer or texture of a .gltf.
bool isPartOf(const fs::path& file, const fs::path& model) {
    if (file.extension() == ".txt")
        return fs::path(model).replace_extension(".txt") == file;
    return model.extension() == ".gltf" && Playlist::isBelow(file, model.parent_path());
}

} // namespace

Content::Content(EventLoop& loop, franken::Log log, EventLoop::Handler arrived)
    : m_loop(loop),
      m_log(std::move(log)),
      m_arrived(std::move(arrived)),
      m_loader([this](const fs::path& model, const std::stop_token& cancel) {
          m_progress = 0;
          return loadModel(model, cancel, [this](float done) { m_progress = done; });
      }) {
    m_loaderSource = loop.onReadable(m_loader.descriptor(), [this] { m_arrived(); });
    m_folderTimer = loop.timer([this] {
        m_folder->rescan();
        folderChanged();
    });
}

void Content::configure(const Config& config) {
    m_listed.assign(config.content.playlist.begin(), config.content.playlist.end());
    m_playlist.forgetBroken();
    if (config.content.folder != m_folderName)
        watchFolder(config.content.folder);
    refresh();
}

void Content::watchFolder(const std::string& folder) {
    m_folderName = folder;
    m_folderSource.reset();
    m_folder.reset();
    m_folderTimer->disarm();
    if (folder.empty())
        return;
    m_folder = std::make_unique<WatchedFolder>(folder, m_log);
    m_folderSource = m_loop.onReadable(m_folder->descriptor(), [this] { folderChanged(); });
    if (std::error_code error; !fs::exists(folder, error))
        m_log(LogLevel::Warning, folder + ": there is no such folder; waiting for it");
    folderChanged();
}

void Content::folderChanged() {
    for (const fs::path& file : m_folder->dispatch())
        noteChange(file);
    if (m_folder->needsRescans())
        m_folderTimer->arm(now() + kLookAgain);
    refresh();
    m_arrived();
}

void Content::noteChange(const fs::path& file) {
    m_playlist.changed(file);
    const std::vector<fs::path>& models = m_playlist.models();
    const bool isModel = std::find(models.begin(), models.end(), file) != models.end();
    for (const fs::path& model : models)
        if (model == file || (!isModel && isPartOf(file, model)))
            m_replaced.insert(model);
}

void Content::refresh() {
    std::vector<fs::path> models = m_listed;
    if (m_folder)
        for (fs::path& model : m_folder->models())
            models.push_back(std::move(model));
    std::erase_if(m_replaced, [&models](const fs::path& file) {
        return std::find(models.begin(), models.end(), file) == models.end();
    });
    if (models == m_playlist.models())
        return;
    m_log(LogLevel::Info, std::to_string(models.size()) + (models.size() == 1 ? " model" : " models"));
    m_playlist.set(std::move(models));
    if (m_reading && !m_playlist.contains(*m_reading))
        cancel();
}

std::optional<fs::path> Content::following(const std::optional<fs::path>& shown, int direction) const {
    if (shown && isReplaced(*shown) && m_playlist.contains(*shown))
        return shown;
    const std::optional<fs::path> next = m_playlist.after(shown, direction);
    return next == shown ? std::nullopt : next;
}

void Content::want(const std::optional<fs::path>& shown, int direction) {
    m_shown = shown;
    m_direction = direction;
    m_reading = following(shown, direction);
    if (!m_reading)
        return m_loader.cancel();
    m_replaced.erase(*m_reading);
    m_loader.request(*m_reading);
}

void Content::cancel() {
    m_loader.cancel();
    m_reading.reset();
}

std::optional<LoadedModel> Content::take() {
    std::optional<LoadedModel> model = m_loader.take();
    if (!model)
        return {};
    m_reading.reset();
    for (const std::string& warning : model->warnings)
        m_log(LogLevel::Warning, warning);
    if (model->scene)
        return model;
    refuse(model->path, model->scene.error());
    return {};
}

void Content::refuse(const fs::path& model, const franken::Error& error) {
    m_log(LogLevel::Error, franken::printable(model.string()) + " is skipped: " + franken::printable(error));
    m_playlist.markBroken(model, franken::toString(error));
    want(m_shown, m_direction);
}

} // namespace kiosk
