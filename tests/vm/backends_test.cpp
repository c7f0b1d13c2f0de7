// SPDX-License-Identifier: MIT
//
// A window, the screen and the offscreen surfaces show the same picture, byte for byte, where one driver
// draws.
#include "franken/gltf.h"
#include "franken/renderer.h"
#include "support/child.h"
#include "support/guest.h"

#include <drm_fourcc.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

namespace franken::test {
namespace {

using namespace std::chrono_literals;
using platform::Backend;

constexpr platform::Size kSize = {160, 120};

/// An X server without a screen, which keeps its picture in a file. It listens to no network, and has a /tmp
/// of its own: the guest's is the host's, and cannot be written.
class XServer {
public:
    XServer()
        : m_folder(std::filesystem::temp_directory_path() / "xvfb"),
          m_server({"/usr/bin/unshare", "--mount", "/bin/sh", "-c",
                    "mount -t tmpfs tmp /tmp && exec Xvfb :7 -nolisten tcp -screen 0 160x120x24 -fbdir " +
                        folderMade(m_folder)},
                   m_folder / "log") {
        setenv("DISPLAY", ":7", 1);
        setenv("SDL_VIDEODRIVER", "x11", 1);
        std::this_thread::sleep_for(3s); // In virtual time: when all has come to rest.
    }
    std::string log() const { return readFile(m_folder / "log"); }
    VmPicture picture() const;

private:
    static std::string folderMade(const std::filesystem::path& folder) {
        std::filesystem::create_directories(folder);
        return folder;
    }
    std::filesystem::path m_folder;
    Child m_server;
};

/// Of the X Window Dump file format: a header of 32-bit words, most significant byte first, a colour map,
/// rows.
VmPicture XServer::picture() const {
    const std::string file = readFile(m_folder / "Xvfb_screen0");
    const auto word = [&](std::size_t index) {
        std::uint32_t value = 0;
        for (std::size_t i = index * 4; i < index * 4 + 4 && i < file.size(); ++i)
            value = value << 8 | static_cast<std::uint8_t>(file[i]);
        return value;
    };
    enum Field { HeaderSize = 0, Width = 4, Height = 5, BitsPerPixel = 11, BytesPerLine = 12, Colours = 19 };
    constexpr std::size_t kColourBytes = 12;
    VmPicture picture{{static_cast<int>(word(Width)), static_cast<int>(word(Height))}, {}};
    EXPECT_EQ(word(BitsPerPixel), 32u);
    for (std::uint32_t y = 0; y < word(Height); ++y)
        for (std::uint32_t x = 0; x < word(Width); ++x) {
            std::uint32_t pixel = 0;
            const std::size_t at =
                word(HeaderSize) + word(Colours) * kColourBytes + y * std::size_t{word(BytesPerLine)} + x * 4;
            if (at + 4 <= file.size())
                std::memcpy(&pixel, &file[at], 4);
            picture.pixels.push_back(pixel & 0xFFFFFF);
        }
    return picture;
}

/// What a kiosk draws.
void drawModel(const platform::Surface& surface) {
    const Result<Scene> scene =
        loadGltf("/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
    ASSERT_TRUE(scene) << toString(scene.error());
    const double aspect = static_cast<double>(kSize.width) / kSize.height;
    Renderer renderer(Gl::load(surface.getProcAddress()).value());
    Lighting lighting;
    lighting.suns = {{.direction = {-1, -2, -3}, .illuminance = 3}};
    renderer.setLighting(lighting);
    ASSERT_TRUE(renderer.load(*scene));
    ASSERT_TRUE(renderer.draw(viewpointOf(framingCamera(scene->bounds(), aspect), aspect),
                              {surface.framebuffer(), kSize.width, kSize.height, {0.1f, 0.2f, 0.4f}}));
}

/// Draws, submits and waits until it is shown; the picture that GL reads back.
VmPicture drawn(platform::Surface& surface) {
    EXPECT_TRUE(waitFor(surface, platform::SurfaceState::Ready, 5s));
    EXPECT_TRUE(surface.begin().value());
    drawModel(surface);
    const VmPicture picture = readPicture(Gl::load(surface.getProcAddress()).value(), kSize);
    EXPECT_TRUE(surface.submit());
    for (int i = 0; i < 100; ++i)
        if (waitAndDispatch(surface, 1s).completed)
            break;
    return picture;
}

class Backends : public GuestTest {
protected:
    void SetUp() override {
        GuestTest::SetUp();
        needs("/usr/bin/Xvfb", "xvfb");
        needs("/usr/share/assimp/models/glTF2", "assimp-testmodels");
    }
};

TEST_F(Backends, AWindowTheScreenAndOffscreenShowTheSameBytes) {
    platform::SurfaceOptions options = GuestTest::options();
    options.size = kSize;
    VmPicture shown, window;
    {
        const auto surface = openSurface(options);
        ASSERT_TRUE(surface);
        drawn(*surface);
        shown = scannedOut(DRM_FORMAT_XRGB8888);
    }
    writePpm(shown, "backend_kms");
    {
        const XServer server;
        const auto surface = platform::create(Backend::Window, options);
        ASSERT_TRUE(surface) << toString(surface.error()) << '\n' << server.log();
        ASSERT_EQ((*surface)->size(), kSize);
        drawn(**surface);
        std::this_thread::sleep_for(1s);
        window = server.picture();
    }
    writePpm(window, "backend_window");
    EXPECT_TRUE(window == shown) << difference(window, shown);
    for (const Backend backend : {Backend::EglSurfaceless, Backend::OsMesa}) {
        const auto surface = platform::create(backend, options);
        ASSERT_TRUE(surface) << toString(surface.error());
        EXPECT_NE((*surface)->driver().find("softpipe"), std::string::npos) << (*surface)->driver();
        const VmPicture offscreen = drawn(**surface);
        const std::string name(toString(backend));
        writePpm(offscreen, "backend_" + name);
        EXPECT_TRUE(offscreen == shown) << name << ": " << difference(offscreen, shown);
    }
}

} // namespace
} // namespace franken::test
