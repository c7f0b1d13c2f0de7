// SPDX-License-Identifier: MIT
// engine OUT.png [FRAMES]: runs the engine's loop for that many frames (60 unless told otherwise) and writes
// the last one.
#include "context.h"
#include "pbr.h"
#include "write_png.h"

#include <cstdlib>
#include <iostream>

namespace {

constexpr int kWidth = 320, kHeight = 240;

/// The renderer of this engine: its own pass first, then what FrankenShader's programs draw.
class Renderer {
public:
    Renderer(const EngineGl& engine, const franken::Gl& gl, const World& world)
        : m_engine(engine),
          m_background(engine),
          m_pbr(engine, gl),
          m_tiles(upload(engine, world.tiles)),
          m_ridges(upload(engine, world.ridges)) {
        for (const Thing& thing : world.things)
            m_meshes.push_back(upload(engine, thing.mesh));
    }

    franken::Result<void> prepare(const World& world) {
        for (const Thing& thing : world.things) {
            franken::Result<Pbr::Look> look = m_pbr.lookOf(thing.paint);
            if (!look)
                return look.error();
            m_looks.push_back(*std::move(look));
        }
        return {};
    }

    void draw(const World& world, float seconds) {
        m_engine.Disable(GL_DITHER);
        m_engine.Viewport(0, 0, kWidth, kHeight);
        m_engine.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        m_background.draw(seconds);
        m_engine.Enable(GL_DEPTH_TEST);
        m_engine.Enable(GL_CULL_FACE);
        bindTexture("uBaseColorTexture", m_tiles);
        bindTexture("uNormalTexture", m_ridges);
        m_pbr.beginFrame(world, static_cast<float>(kWidth) / kHeight);
        for (std::size_t i = 0; i < world.things.size(); ++i)
            m_pbr.draw(world.things[i], m_looks[i], m_meshes[i]);
    }

    const franken::ProgramCounters& counters() const { return m_pbr.counters(); }

private:
    void bindTexture(const char* sampler, GLuint texture) const {
        m_engine.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(franken::samplerUnit(sampler)));
        m_engine.BindTexture(GL_TEXTURE_2D, texture);
    }

    const EngineGl& m_engine;
    Background m_background;
    Pbr m_pbr;
    GLuint m_tiles, m_ridges;
    std::vector<GpuMesh> m_meshes;
    std::vector<Pbr::Look> m_looks;
};

int fail(const std::string& why) {
    std::cerr << "engine: " << why << "\n";
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2)
        return fail("usage: engine OUT.png [FRAMES]");
    const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
    Context context;
    if (const char* call = context.open(kWidth, kHeight))
        return fail(std::string(call) + " failed");
    const EngineGl engine = EngineGl::load();
    const franken::Result<franken::Gl> gl = franken::Gl::load(Context::getProcAddress);
    if (!gl)
        return fail(toString(gl.error()));

    World world = makeWorld();
    Renderer renderer(engine, *gl, world);
    if (const franken::Result<void> prepared = renderer.prepare(world); !prepared)
        return fail(toString(prepared.error()));
    for (int frame = 0; frame < frames; ++frame) {
        const float seconds = static_cast<float>(frame) / 60;
        animate(world, seconds);
        renderer.draw(world, seconds);
    }

    std::vector<std::uint8_t> picture(4 * kWidth * kHeight);
    engine.ReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
    if (const GLenum error = engine.GetError(); error != GL_NO_ERROR)
        return fail("GL error " + std::to_string(error));
    std::cout << frames << " frames, " << renderer.counters().compiles << " compiles, "
              << renderer.counters().links << " links\n";
    return writePng(argv[1], kWidth, kHeight, picture) ? 0 : fail(std::string(argv[1]) + " is not written");
}
