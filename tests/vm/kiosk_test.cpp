// SPDX-License-Identifier: MIT
//
// examples/embed/kiosk, built against the installed package alone, as a process of its own. In virtual time.
#include "support/child.h"
#include "support/guest.h"
#include "support/sim_chip.h"

#include <drm_fourcc.h>

#include <algorithm>
#include <thread>

namespace franken::test {
namespace {

using namespace std::chrono_literals;

const std::string kModels = "/usr/share/assimp/models/glTF2/";

/// What of the picture is not black.
double share(const VmPicture& picture) {
    const auto drawn = std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                     [](std::uint32_t pixel) { return pixel != 0; });
    return static_cast<double>(drawn) / static_cast<double>(picture.pixels.size());
}

class Kiosk : public GuestTest {
protected:
    void SetUp() override {
        GuestTest::SetUp();
        needs(kModels, "assimp-testmodels");
    }
    void TearDown() override {
        if (!IsSkipped())
            plug("detect");
    }
    /// In virtual time: long enough for everything that does not wait itself.
    static VmPicture shownBy(const Child& kiosk, const std::string& name) {
        std::this_thread::sleep_for(500ms);
        VmPicture picture = scannedOut(DRM_FORMAT_XRGB8888, kiosk.process());
        writePpm(picture, name);
        return picture;
    }
    static void press(const SimChip& chip) {
        for (const bool up : {false, true, false, true}) { // It bounces.
            chip.pull(17, up);
            std::this_thread::sleep_for(up ? 3ms : 60ms);
        }
    }
    static std::vector<std::string> command() {
        return {FRANKEN_KIOSK, kModels + "BoxTextured-glTF-Binary/BoxTextured.glb",
                kModels + "2CylinderEngine-glTF-Binary/2CylinderEngine.glb"};
    }
};

TEST_F(Kiosk, ShowsAModelAndTheButtonShowsTheNext) {
    setenv("KIOSK_SOFTWARE", "1", 1);
    const SimChip chip;
    chip.pull(17, true);
    Child kiosk(command());
    const VmPicture box = shownBy(kiosk, "kiosk_box");
    EXPECT_GT(share(box), 0.1);
    press(chip);
    const VmPicture engine = shownBy(kiosk, "kiosk_engine");
    EXPECT_GT(share(engine), 0.1);
    EXPECT_FALSE(engine == box) << "the button changed nothing";
    press(chip);
    EXPECT_TRUE(shownBy(kiosk, "kiosk_again") == box) << "the first model does not come again";
    plug("off");
    std::this_thread::sleep_for(5s);
    plug("detect");
    EXPECT_TRUE(shownBy(kiosk, "kiosk_plugged") == box) << "the picture does not come back";
    EXPECT_TRUE(kiosk.runs());
}

} // namespace
} // namespace franken::test
