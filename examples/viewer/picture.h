// SPDX-License-Identifier: MIT
#pragma once

#include "franken/baked_sky.h"
#include "franken/generator/snippet_set.h"
#include "franken/image.h"
#include "franken/light.h"
#include "franken/scene.h"
#include "options.h"

#include <optional>

/// Everything that a picture shows.
struct Subject {
    franken::Scene scene;
    franken::Camera camera;
    franken::Lighting lighting;
    std::optional<franken::BakedSky> sky;
};

/// The programs that a picture needs, that of the backdrop included.
franken::Result<std::vector<franken::Permutation>>
permutationsFor(const Subject& subject, const franken::Look& look, const franken::Log& log);

/// Opens a context, draws, and reads the picture back, row 0 at the top. With snippets of the user's own,
/// each program must compile: the error says where it does not, and no simpler program stands in.
franken::Result<franken::Image> drawPicture(const Subject& subject, const Options& options,
                                            const std::optional<franken::SnippetSet>& snippets,
                                            const franken::Log& log);
