// SPDX-License-Identifier: MIT
#include "picture.h"

#include "franken/renderer.h"

#include <algorithm>

using namespace franken;

namespace {

Image readTopDown(const Gl& gl, platform::Size size) {
    const std::size_t row = 4 * static_cast<std::size_t>(size.width);
    Image image;
    image.width = size.width;
    image.height = size.height;
    image.rgba.resize(row * static_cast<std::size_t>(size.height));
    gl.ReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    const auto rowAt = [&](int y) { return image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y; };
    for (int low = 0, high = size.height - 1; low < high; ++low, --high)
        std::swap_ranges(rowAt(low), rowAt(low + 1), rowAt(high));
    return image;
}

// Averages codes, not light: what a display and MSAA on a GPU without sRGB targets do.
Image halved(const Image& image) {
    Image half;
    half.width = image.width / 2;
    half.height = image.height / 2;
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const std::uint8_t* p = image.rgba.data() + 2 * static_cast<std::size_t>(y) * row +
                                        8 * static_cast<std::size_t>(x) + channel;
                half.rgba.push_back(static_cast<std::uint8_t>((p[0] + p[4] + p[row] + p[row + 4] + 2) / 4));
            }
    return half;
}

bool hasBackdrop(const Subject& subject) { return subject.sky && subject.sky->backdrop.size > 0; }

Result<void> tryPrograms(const Gl& gl, const SnippetSet& snippets, const Subject& subject, const Look& look) {
    const Result<std::vector<Permutation>> needed = permutationsFor(subject, look, {});
    if (!needed)
        return needed.error();
    ProgramCache cache(gl);
    cache.setSnippets(snippets);
    for (const Permutation& permutation : *needed)
        if (const Result<ProgramHandle> program = cache.get(permutation); !program)
            return program.error();
    return {};
}

Result<void> draw(const Gl& gl, const platform::Surface& surface, const Subject& subject,
                  const Options& options, const std::optional<SnippetSet>& snippets, const Log& log) {
    const platform::Size size = surface.size();
    Look look = options.look;
    look.srgbTarget = surface.srgbTarget();
    Renderer renderer(gl, log);
    if (snippets) {
        if (Result<void> tried = tryPrograms(gl, *snippets, subject, look); !tried)
            return tried;
        renderer.setSnippets(*snippets);
    }
    if (Result<void> loaded = renderer.load(subject.scene); !loaded)
        return loaded;
    if (subject.sky) {
        if (Result<void> shown =
                renderer.setBackdrop(hasBackdrop(subject) ? &subject.sky->backdrop : nullptr);
            !shown)
            return shown;
        if (Result<void> mirrored = renderer.setMirror(&subject.sky->mirror); !mirrored)
            return mirrored;
    }
    renderer.setLighting(subject.lighting);
    renderer.setLook(look);
    const Camera camera = tightened(subject.camera, subject.scene.bounds());
    return renderer.draw(viewpointOf(camera, static_cast<double>(size.width) / size.height),
                         {.framebuffer = surface.framebuffer(),
                          .width = size.width,
                          .height = size.height,
                          .background = options.background});
}

} // namespace

Result<std::vector<Permutation>> permutationsFor(const Subject& subject, const Look& look, const Log& log) {
    Result<std::vector<Permutation>> needed = permutationsOf(subject.scene, subject.lighting, look, log);
    if (!needed || !hasBackdrop(subject))
        return needed;
    const Result<Permutation> backdrop = skyPermutation(look);
    if (!backdrop)
        return backdrop.error();
    needed->push_back(*backdrop);
    return needed;
}

Result<Image> drawPicture(const Subject& subject, const Options& options,
                          const std::optional<SnippetSet>& snippets, const Log& log) {
    const int scale = options.supersample ? 2 : 1;
    const platform::Size size = {options.size.width * scale, options.size.height * scale};
    const Result<std::unique_ptr<platform::Surface>> surface =
        platform::create(options.backend, {.size = size, .log = log});
    if (!surface)
        return surface.error();
    const Result<Gl> gl = Gl::load((*surface)->getProcAddress());
    if (!gl)
        return gl.error();
    if (Result<void> drawn = draw(*gl, **surface, subject, options, snippets, log); !drawn)
        return drawn.error();
    const Image image = readTopDown(*gl, size);
    return options.supersample ? halved(image) : image;
}
