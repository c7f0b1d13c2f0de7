// SPDX-License-Identifier: MIT
#include "device.h"

#include "franken/guard.h"

namespace franken {
namespace {

template<typename Return, typename... Arguments>
void doNothing(Return(GL_APIENTRY*& function)(Arguments...)) {
    function = [](Arguments...) { return Return(); };
}

/// The table of a context that is gone: no call reaches the driver.
Gl deadTable() {
    Gl gl;
#define FRANKEN_DEAD(name) doNothing(gl.name);
    FRANKEN_GL_FUNCTIONS(FRANKEN_DEAD)
#undef FRANKEN_DEAD
    return gl;
}

} // namespace

Device::Device(const Gl& table, const Capabilities& found, Log log_)
    : gl(table), capabilities(found), log(guardedLog(std::move(log_))) {}

void Device::lost() {
    isLost = true;
    gl = deadTable();
    state.invalidate();
}

void Device::restore(const Gl& table, const Capabilities& found) {
    isLost = false;
    gl = table;
    capabilities = found;
    state.invalidate();
}

void Device::begin(const DrawTarget& target) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    const TargetArea area = areaOf(target);
    gl.Viewport(area.x, area.y, area.width, area.height);
    state.setBaseline();
}

} // namespace franken
