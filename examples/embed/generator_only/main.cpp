// SPDX-License-Identifier: MIT
// generator_only OUT.png [NAME]: draws a panel with the program of that name, "sun1" unless told
// otherwise.
#include "context.h"
#include "panel.h"
#include "program.h"
#include "write_png.h"

#include <iostream>

using namespace franken;

namespace {

int fail(const std::string& why) {
    std::cerr << "generator_only: " << why << "\n";
    return 1;
}

Result<Permutation> permutationOf(const char* name) {
    const Result<Permutation> parsed = parseName(name);
    if (!parsed)
        return parsed;
    const Result<Canonical> canonical = canonicalise(*parsed);
    return canonical ? canonical->permutation : Result<Permutation>(canonical.error());
}

Values valuesFor(const Permutation& permutation) {
    constexpr Float16 kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    Values values;
    values.frame.cameraPosition = kEye;
    for (std::size_t sun = 0; sun < permutation.suns; ++sun)
        packSun(values.lights, sun, kSun, 1);
    values.material = packMaterial(kPanel, permutation.brdf, 1);
    values.object.modelViewProjection = kIdentity;
    values.object.model = kIdentity;
    values.object.normalMatrix = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    return values;
}

void drawPanel() {
    const auto position = static_cast<GLuint>(attributeLocation("aPosition"));
    const auto normal = static_cast<GLuint>(attributeLocation("aNormal"));
    constexpr float kCorners[] = {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0};
    glViewport(0, 0, kPixels, kPixels);
    glVertexAttribPointer(position, 3, GL_FLOAT, GL_FALSE, 0, kCorners);
    glEnableVertexAttribArray(position);
    glVertexAttrib3f(normal, 0, 0, 1);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2)
        return fail("usage: generator_only OUT.png [NAME]");
    const Result<Permutation> permutation = permutationOf(argc > 2 ? argv[2] : "sun1");
    if (!permutation)
        return fail(toString(permutation.error()));
    Context context;
    if (const char* call = context.open(kPixels, kPixels))
        return fail(std::string(call) + " failed");

    const Composed composed = compose(*permutation);
    const Result<GLuint> program = makeProgram(composed);
    if (!program)
        return fail(toString(program.error()));
    setUniforms(*program, composed.interface, valuesFor(*permutation));
    drawPanel();

    std::vector<std::uint8_t> picture(4 * kPixels * kPixels);
    glReadPixels(0, 0, kPixels, kPixels, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    return writePng(argv[1], kPixels, kPixels, picture) ? 0 : fail(std::string(argv[1]) + " is not written");
}
