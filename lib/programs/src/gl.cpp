// SPDX-License-Identifier: MIT
#include "franken/gl.h"

#include <string>

namespace franken {

Result<Gl> Gl::load(const GetProcAddress& getProcAddress) {
    Gl gl;
    std::string missing;
    const auto find = [&]<typename Function>(Function*& function, const char* name) {
        function = reinterpret_cast<Function*>(getProcAddress(name));
        if (function == nullptr)
            missing += missing.empty() ? name : std::string(", ") + name;
    };
#define FRANKEN_GL_FIND(name) find(gl.name, "gl" #name);
    FRANKEN_GL_FUNCTIONS(FRANKEN_GL_FIND)
#undef FRANKEN_GL_FIND

    if (!missing.empty())
        return Error{"gl.missing-functions", missing, "the context lacks these functions of OpenGL ES 2.0",
                     "use an OpenGL ES 2.0 context, or one of OpenGL with GL_ARB_ES2_compatibility"};
    return gl;
}

} // namespace franken
