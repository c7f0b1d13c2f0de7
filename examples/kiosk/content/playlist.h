// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kiosk {

/// The order in which models are shown. Pure: it reads no file. Broken models are skipped until their file,
/// or one beside it, changes.
class Playlist {
public:
    using Path = std::filesystem::path;

    /// The models that there are now.
    void set(std::vector<Path> models);

    /// What follows the model that is shown, or comes before it (direction -1); nothing where no model is
    /// whole. Alone, a model follows itself.
    std::optional<Path> after(const std::optional<Path>& shown, int direction = 1) const;

    void markBroken(const Path& model, std::string reason);
    /// A file in a broken model's folder, or deeper, changed, or all of a folder may have: the model is tried
    /// again.
    void changed(const Path& file);
    /// Tries all broken models again.
    void forgetBroken() { m_broken.clear(); }

    bool contains(const Path& model) const;
    const std::vector<Path>& models() const { return m_models; }
    const std::map<Path, std::string>& broken() const { return m_broken; }

    /// Whether it is in the folder, or deeper.
    static bool isBelow(const Path& path, const Path& folder);

private:
    std::vector<Path> m_models;
    std::map<Path, std::string> m_broken; ///< With the reason.
};

} // namespace kiosk
