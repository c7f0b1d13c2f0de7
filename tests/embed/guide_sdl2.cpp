// SPDX-License-Identifier: MIT
// The block for SDL 2 of examples/toolkits/README.md, compiled. The example beside it is drawn.
#include "franken/renderer.h"

#include <SDL.h>

void report(const franken::Result<void>& result);

void drawFrame(SDL_Renderer* sdl, franken::Renderer& renderer, const franken::Viewpoint& viewpoint, int width,
               int height) {
#include "blocks/examples/toolkits/sdl-2.inc"
}
