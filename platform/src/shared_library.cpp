// SPDX-License-Identifier: MIT
#include "shared_library.h"

#include <dlfcn.h>

#include <string>

namespace franken::platform {

Result<SharedLibrary> SharedLibrary::open(const char* name, const char* remedy) {
    void* const handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
        return Error{"surface.not-installed", "dlopen", dlerror(), remedy};
    return SharedLibrary(handle, name, remedy);
}

Result<void> SharedLibrary::found() const {
    if (m_missing != nullptr)
        return Error{"surface.not-installed", m_name, std::string("the library has no ") + m_missing,
                     m_remedy};
    return {};
}

void* SharedLibrary::address(const char* name) {
    void* const found = dlsym(m_handle, name);
    if (found == nullptr)
        m_missing = name;
    return found;
}

} // namespace franken::platform
