// SPDX-License-Identifier: MIT
#pragma once

#include "franken/result.h"

namespace franken::platform {

/// A library that is found at run time, and never unloaded.
class SharedLibrary {
public:
    /// Fails with "surface.not-installed", and that remedy.
    static Result<SharedLibrary> open(const char* name, const char* remedy);

    template<typename Function>
    void find(Function*& function, const char* name) {
        function = reinterpret_cast<Function*>(address(name));
    }

    /// Fails with "surface.not-installed" where find() did not find a function.
    Result<void> found() const;

private:
    SharedLibrary(void* handle, const char* name, const char* remedy)
        : m_handle(handle), m_name(name), m_remedy(remedy) {}

    void* address(const char* name);

    void* m_handle;
    const char* m_name;
    const char* m_remedy;
    const char* m_missing = nullptr; ///< The last function that is not there.
};

} // namespace franken::platform
