// SPDX-License-Identifier: MIT
// Built with -fno-exceptions -fno-rtti, as the libraries beside it: draws a triangle, and reads an error.
#include "franken/renderer.h"
#include "support/null_gl.h"

#include <cstdio>

using namespace franken;

int main() {
    Scene scene;
    scene.materials.emplace_back();
    Primitive triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.normals.assign(3, {0, 0, 1});
    triangle.indices = {0, 1, 2};
    scene.meshes.push_back({"triangle", {triangle}});
    scene.instances.emplace_back();

    Renderer renderer(test::nullGl());
    Result<void> drawn = renderer.load(scene);
    if (drawn)
        drawn = renderer.draw({}, {.width = 64, .height = 64});
    scene.meshes[0].primitives[0].indices[0] = 3;
    const Result<void> refused = renderer.load(scene);
    std::printf("%s; %s\n", drawn ? "drawn" : toString(drawn.error()).c_str(),
                refused ? "no error" : toString(refused.error()).c_str());
    return drawn && !refused ? 0 : 1;
}
