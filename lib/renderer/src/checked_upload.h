// SPDX-License-Identifier: MIT
#pragma once

#include "device.h"
#include "franken/context_check.h"

namespace franken {

/// What `make` returns (a Result), after a look at GL's errors. Leaves GL's state unknown. Fails as `make`
/// does, and with "renderer.memory" and "renderer.context-lost".
template<typename Make>
auto checkedOnce(Device& device, Make make) -> decltype(make()) {
    device.state.invalidate();
    decltype(make()) made = make();
    if (Result<void> checked = checkErrors(device.gl); !checked)
        return checked.error();
    if (!answers(device.gl))
        return contextLost();
    return made;
}

/// The same; where the GPU's memory does not suffice, all that can be evicted is evicted, and `make` is
/// called once more.
template<typename Make>
auto checkedUpload(Device& device, Make make) {
    decltype(make()) made = checkedOnce(device, make);
    if (!made && made.error().code == "renderer.memory" && device.memory.evictAll())
        return checkedOnce(device, make);
    return made;
}

} // namespace franken
