// SPDX-License-Identifier: MIT
#include "franken/capabilities.h"
#include "kiosk/doctor/examine.h"
#include "kiosk/screen.h"

namespace kiosk {

namespace platform = franken::platform;

namespace {

using Kind = Finding::Kind;

bool isSoftware(const std::string& driver) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast"})
        if (driver.find(name) != std::string::npos)
            return true;
    return false;
}

std::string profileOf(const std::string& driver) {
    if (driver.find("VC4") != std::string::npos)
        return "vc4";
    return driver.find("V3D") != std::string::npos ? "v3d" : "software";
}

} // namespace

Findings examineRenderer(const Patient& patient) {
    platform::SurfaceOptions options = surfaceOptionsOf(patient.config, {});
    options.shaderCache.clear();
    options.size = {64, 64};
    const auto surface = platform::create(platform::Backend::EglSurfaceless, options);
    if (!surface)
        return {{Kind::Bad, "renderer", surface.error().what,
                 surface.error().remedy.empty() ? "sudo apt install libegl1 libgl1-mesa-dri"
                                                : surface.error().remedy}};
    const std::string driver = (*surface)->driver();
    Findings findings;
    if (isSoftware(driver) && !patient.config.screen.allowSoftware)
        findings.push_back({Kind::Bad, "renderer", "the processor draws, at a few frames a second: " + driver,
                            "add dtoverlay=vc4-kms-v3d to /boot/firmware/config.txt, then sudo reboot"});
    else
        findings.push_back({Kind::Good, "renderer", driver + "; profile " + profileOf(driver), ""});
    if (const auto gl = franken::Gl::load((*surface)->getProcAddress())) {
        const franken::Capabilities can = franken::Capabilities::query(*gl);
        findings.push_back({Kind::Note, "renderer",
                            "textures up to " + std::to_string(can.maxTextureSize) + ", " +
                                (can.wideIndices ? "32" : "16") + "-bit indices, " +
                                (can.precision == franken::Precision::Fp32 ? "32" : "16") + "-bit floats",
                            ""});
    }
    return findings;
}

} // namespace kiosk
