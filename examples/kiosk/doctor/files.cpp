// SPDX-License-Identifier: MIT
#include "kiosk/doctor/examine.h"

#include <unistd.h>

#include <filesystem>

namespace kiosk {

namespace fs = std::filesystem;

namespace {

using Kind = Finding::Kind;

constexpr std::uintmax_t kLeastSpace = std::uintmax_t{50} << 20;

void examineFolder(const std::string& folder, const std::string& setting, bool isWritten,
                   Findings& findings) {
    if (folder.empty())
        return;
    std::error_code error;
    if (!fs::is_directory(folder, error))
        return findings.push_back({Kind::Bad, "files", folder + " (" + setting + ") is not there",
                                   "sudo install -d -o " + userName() + " " + folder});
    if (access(folder.c_str(), isWritten ? R_OK | W_OK | X_OK : R_OK | X_OK) != 0)
        return findings.push_back(
            {Kind::Bad, "files", folder + " (" + setting + ") may not be " + (isWritten ? "written" : "read"),
             "sudo chown " + userName() + " " + folder});
    const fs::space_info space = fs::space(folder, error);
    if (isWritten && !error && space.available < kLeastSpace)
        return findings.push_back({Kind::Bad, "files",
                                   folder + " (" + setting + ") is on a disk that is full",
                                   "df -h " + folder + "; sudo journalctl --vacuum-size=50M"});
    findings.push_back({Kind::Good, "files", folder + " (" + setting + ")", ""});
}

} // namespace

Findings examineFiles(const Patient& patient) {
    Findings findings;
    const Config& config = patient.config;
    examineFolder(config.content.folder, "content.folder", false, findings);
    examineFolder(config.files.state, "files.state", true, findings);
    if (!config.files.metrics.empty())
        examineFolder(fs::path(config.files.metrics).parent_path().string(), "files.metrics", true, findings);
    std::error_code error;
    for (const std::string& model : config.content.playlist)
        if (!fs::exists(model, error))
            findings.push_back({Kind::Bad, "files", model + " (content.playlist) is not there",
                                "ls " + fs::path(model).parent_path().string()});
    if (config.content.folder.empty() && config.content.playlist.empty())
        findings.push_back(
            {Kind::Note, "files", "no model is named: content.folder and content.playlist are empty", ""});
    return findings;
}

} // namespace kiosk
