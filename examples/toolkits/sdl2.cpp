// SPDX-License-Identifier: MIT
// toolkit_sdl2 MODEL [PICTURE.png...]: a model beside what an SDL_Renderer draws. A drag turns the model; a
// click at the left sets the sun. Writes a frame for each picture that is named, and leaves.
#include "franken/png.h"
#include "model_view.h"

#include <SDL.h>

#include <iostream>
#include <span>
#include <vector>

using namespace franken;

namespace {

constexpr int kPanel = 80; // Width, pixels.

struct Window {
    Window();
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    SDL_Window* window = nullptr;
    SDL_Renderer* sdl = nullptr; // Owns the context.
};

Window::Window() {
    SDL_Init(SDL_INIT_VIDEO);
    SDL_SetHint(SDL_HINT_RENDER_DRIVER, "opengles2");
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 2);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24); // SDL's own renderer needs none.
    window = SDL_CreateWindow("FrankenShader in SDL", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, 320,
                              240, SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    if (window != nullptr)
        sdl = SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC);
}

Window::~Window() {
    SDL_DestroyRenderer(sdl);
    SDL_DestroyWindow(window);
    SDL_Quit();
}

void fill(SDL_Renderer* sdl, const SDL_Rect& rectangle, const SDL_Color& color) {
    SDL_SetRenderDrawBlendMode(sdl, SDL_BLENDMODE_BLEND);
    SDL_SetRenderDrawColor(sdl, color.r, color.g, color.b, color.a);
    SDL_RenderFillRect(sdl, &rectangle);
}

Result<void> drawFrame(SDL_Renderer* sdl, ModelView& view) {
    int width = 0, height = 0;
    SDL_GetRendererOutputSize(sdl, &width, &height);
    const int level = static_cast<int>(view.sun() / ModelView::kBrightest * static_cast<float>(height));
    fill(sdl, {0, 0, kPanel, height}, {32, 48, 64, 255});
    fill(sdl, {20, height - level, kPanel - 40, level}, {255, 200, 60, 255});

    SDL_RenderFlush(sdl); // SDL keeps its draws; they come first.
    const TargetArea area = {kPanel, 0, width - kPanel, height};
    const DrawTarget target = {
        .width = width, .height = height, .background = {0.1f, 0.1f, 0.1f}, .area = area};
    const Result<void> drawn = view.draw(target);

    fill(sdl, {kPanel, height - 40, area.width, 40}, {0, 0, 255, 128}); // Over the model.
    return drawn;
}

/// Of what was drawn since the last present.
Result<void> writeFrame(SDL_Renderer* sdl, const char* file) {
    Image image;
    SDL_GetRendererOutputSize(sdl, &image.width, &image.height);
    image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    SDL_RenderReadPixels(sdl, nullptr, SDL_PIXELFORMAT_RGBA32, image.rgba.data(), 4 * image.width);
    return writePng(file, image);
}

bool handleEvents(SDL_Window* window, ModelView& view) {
    int width = 0, height = 0;
    SDL_GetWindowSize(window, &width, &height);
    bool goesOn = true;
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
        const SDL_MouseMotionEvent& motion = event.motion;
        if (event.type == SDL_QUIT)
            goesOn = false;
        else if (event.type == SDL_MOUSEMOTION && motion.state != 0 && motion.x >= kPanel)
            view.drag(1.0 * motion.xrel / height, 1.0 * motion.yrel / height);
        else if (event.type == SDL_MOUSEBUTTONDOWN && event.button.x < kPanel)
            view.setSun(ModelView::kBrightest *
                        (1 - static_cast<float>(event.button.y) / static_cast<float>(height)));
    }
    return goesOn;
}

Result<void> run(const char* model, std::span<char*> pictures) {
    const Window window;
    if (window.sdl == nullptr)
        return Error{"sdl", "SDL_CreateRenderer", SDL_GetError(), "start it where SDL finds a screen"};
    const Result<std::unique_ptr<ModelView>> view = ModelView::open(SDL_GL_GetProcAddress, model);
    if (!view)
        return view.error();
    for (std::size_t frame = 0;
         pictures.empty() ? handleEvents(window.window, **view) : frame < pictures.size(); ++frame) {
        Result<void> done = drawFrame(window.sdl, **view);
        if (done && !pictures.empty())
            done = writeFrame(window.sdl, pictures[frame]);
        if (!done)
            return done;
        SDL_RenderPresent(window.sdl);
    }
    return {};
}

} // namespace

int main(int count, char** words) {
    if (count < 2)
        return std::cerr << "usage: toolkit_sdl2 MODEL [PICTURE.png...]\n", 2;
    const Result<void> done = run(words[1], {words + 2, words + count});
    if (!done)
        std::cerr << "toolkit_sdl2: " << toString(done.error()) << "\n";
    return done ? 0 : 1;
}
