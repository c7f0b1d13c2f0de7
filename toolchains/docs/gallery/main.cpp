// SPDX-License-Identifier: MIT
// gallery PRICES.tsv PAGE.md PICTURES_DIR: a picture of each option of each choice, and the page that shows
// them.
#include "franken/file_writer.h"
#include "franken/platform/surface.h"
#include "franken/png.h"
#include "page.h"
#include "studio.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <tuple>

using namespace franken;
using namespace franken::gallery;

namespace {

/// What any of the choice's options needs, all of them are shown with.
Scenery sceneryOf(const ChoiceProgram& row) {
    const auto any = [&](auto needs) { return std::any_of(row.programs.begin(), row.programs.end(), needs); };
    return {.open = any([](const Permutation& p) { return p.sides == Sides::Double; }),
            .striped = any([](const Permutation& p) { return p.alpha != Alpha::Opaque; }),
            .coarse = any([](const Permutation& p) { return p.dither != Dither::None; })};
}

/// Options of different choices often have the same program: each picture is drawn once.
class Pictures {
public:
    explicit Pictures(Studio& studio) : m_studio(studio) {}

    Result<Image> of(const Permutation& program, const Scenery& scenery) {
        const auto key = std::tuple(toName(program), scenery.open, scenery.striped, scenery.coarse);
        if (const auto found = m_drawn.find(key); found != m_drawn.end())
            return found->second;
        Result<Image> image = m_studio.draw(program, scenery);
        if (image)
            m_drawn.emplace(key, *image);
        return image;
    }

private:
    Studio& m_studio;
    std::map<std::tuple<std::string, bool, bool, bool>, Image> m_drawn;
};

Result<void> drawAll(Studio& studio, const std::vector<ChoiceProgram>& choices,
                     const std::filesystem::path& folder) {
    Pictures pictures(studio);
    for (const ChoiceProgram& row : choices)
        for (std::size_t i = 0; i < row.programs.size(); ++i) {
            const Result<Image> image = pictures.of(row.programs[i], sceneryOf(row));
            if (!image)
                return image.error();
            const std::filesystem::path file = folder / pictureName(row.choice->options[i]);
            if (Result<void> written = writePng(file, *image); !written)
                return written;
        }
    return {};
}

Result<void> run(const char* prices, const char* page, const char* pictures) {
    const Result<std::vector<ChoiceProgram>> choices = choicePrograms();
    if (!choices)
        return choices.error();
    const Result<PriceTable> table = readPrices(prices);
    if (!table)
        return table.error();
    const Result<std::string> text = pageOf(*choices, *table);
    if (!text)
        return text.error();
    if (Result<void> written = writeFile(page, *text); !written)
        return written;
    setenv("GALLIUM_DRIVER", "softpipe", 0); // The same picture on every machine.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    const auto surface =
        platform::create(platform::Backend::EglSurfaceless, {.size = {Studio::kSize, Studio::kSize}});
    if (!surface)
        return surface.error();
    const Result<Gl> gl = Gl::load((*surface)->getProcAddress());
    if (!gl)
        return gl.error();
    Studio studio(*gl, (*surface)->framebuffer());
    return drawAll(studio, *choices, pictures);
}

} // namespace

int main(int count, char** words) {
    if (count != 4) {
        std::cerr << "usage: gallery PRICES.tsv PAGE.md PICTURES_DIR\n";
        return 2;
    }
    const Result<void> done = run(words[1], words[2], words[3]);
    if (!done)
        std::cerr << "gallery: " << toString(done.error()) << "\n";
    return done ? 0 : 1;
}
