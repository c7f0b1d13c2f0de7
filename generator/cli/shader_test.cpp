// SPDX-License-Identifier: MIT
#include "shader_test.h"

namespace franken::cli {

std::string toShaderTest(const Composed& program) {
    return "[require]\nGL ES >= 2.0\nGLSL ES >= 1.00\n\n[vertex shader]\n" + program.vertex.text +
           "\n[fragment shader]\n" + program.fragment.text + "\n[test]\nlink success\n";
}

} // namespace franken::cli
