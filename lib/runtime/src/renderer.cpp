// SPDX-License-Identifier: MIT
#include "franken/renderer.h"

#include "gpu_scene.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <optional>
#include <tuple>

namespace franken {
namespace {

Float3 toFloat3(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Rounded to float only here.
template<typename Values, typename Matrix>
void round(Values& values, const Matrix& matrix) {
    std::transform(glm::value_ptr(matrix), glm::value_ptr(matrix) + values.size(), values.begin(),
                   [](double value) { return static_cast<float>(value); });
}

/// The inverse transpose up to a factor; a matrix that squashes to a plane has one as well.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

ObjectBlock packObject(const Drawable& drawable, const glm::dmat4& viewProjection) {
    ObjectBlock block{};
    round(block.modelViewProjection, viewProjection * drawable.world);
    round(block.model, drawable.world);
    const double side = drawable.mirrored ? -1 : 1;
    round(block.normalMatrix, side * cofactors(glm::dmat3(drawable.world)));
    return block;
}

/// Whether one light may follow the other without other programs and other material blocks.
bool sameShape(const Lighting& a, const Lighting& b) {
    const auto spots = [](const Lighting& lighting) {
        return std::any_of(lighting.lamps.begin(), lighting.lamps.end(),
                           [](const Lamp& lamp) { return lamp.spot; });
    };
    return a.suns.size() == b.suns.size() && a.lamps.size() == b.lamps.size() && spots(a) == spots(b) &&
           a.ambient == b.ambient && a.exposure == b.exposure;
}

constexpr unsigned kSkyUnit = 6;

} // namespace

struct Renderer::State {
    State(const Gl& table, const Capabilities& found, Log log_)
        : gl(table), capabilities(found), log(std::move(log_)), cache(gl), defaults(gl) {}

    Result<void> resolvePrograms();
    void sortOpaque();
    void updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target);
    void beginFrame(const DrawTarget& target);
    void use(ShaderProgram& program, const BlockViews& blocks);
    void drawOne(const Drawable& drawable);
    void drawBackdrop();
    void drawBlended(const Viewpoint& viewpoint);

    const Gl& gl;
    const Capabilities capabilities;
    const Log log;
    ProgramCache cache;
    DefaultTextures defaults;

    GpuScene scene;
    std::vector<std::size_t> opaque, blended; ///< Indices of drawables.
    GlTexture sky;
    GlBuffer skyTriangle;
    float skyRange = 0;
    ShaderProgram* skyProgram = nullptr;

    Lighting lighting;
    Look look;
    bool resolved = false;
    UniformBlock<FrameBlock> frame;
    UniformBlock<LightsBlock> lights;
    unsigned enabledAttributes = 0; ///< Bit n: the array of location n.
};

Result<void> Renderer::State::resolvePrograms() {
    if (resolved)
        return {};
    for (GpuMaterial& material : scene.materials) {
        const Result<Permutation> permutation = permutationOf(material.plan, lighting, look);
        if (!permutation)
            return permutation.error();
        const Result<ShaderProgram*> program = cache.get(*permutation);
        if (!program)
            return program.error();
        material.program = *program;
        material.block.edit() = packMaterial(material.plan.factors, look.brdf, lighting.exposure);
    }
    if (sky) {
        const Result<Permutation> permutation = skyPermutation(look);
        if (!permutation)
            return permutation.error();
        const Result<ShaderProgram*> program = cache.get(*permutation);
        if (!program)
            return program.error();
        skyProgram = *program;
    }
    sortOpaque();
    resolved = true;
    return {};
}

void Renderer::State::sortOpaque() {
    const auto order = [this](std::size_t index) {
        const Drawable& drawable = scene.drawables[index];
        return std::tuple(scene.materials[drawable.material].program->name(), drawable.material,
                          drawable.mesh);
    };
    std::sort(opaque.begin(), opaque.end(),
              [&](std::size_t a, std::size_t b) { return order(a) < order(b); });
}

void Renderer::State::updateBlocks(const Viewpoint& viewpoint, const DrawTarget& target) {
    FrameBlock& values = frame.edit();
    values.cameraPosition = toFloat3(viewpoint.eye);
    round(values.clipToSky, viewpoint.clipToSky);
    values.skyRange = skyRange * lighting.exposure;
    values.dither = packDither(target.bits);
    lights.edit() = packLighting(lighting, toFloat3(viewpoint.eye));
    for (Drawable& drawable : scene.drawables)
        drawable.block.edit() = packObject(drawable, viewpoint.viewProjection);
}

void Renderer::State::beginFrame(const DrawTarget& target) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.Viewport(0, 0, target.width, target.height);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_DITHER);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_POLYGON_OFFSET_FILL);
    gl.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    gl.Disable(GL_SAMPLE_COVERAGE);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
    gl.DepthRangef(0, 1);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.CullFace(GL_BACK);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    constexpr GLuint kAttributes = 8;
    for (GLuint location = 0; location < kAttributes; ++location)
        gl.DisableVertexAttribArray(location);
    enabledAttributes = 0;
    gl.ClearColor(target.background[0], target.background[1], target.background[2], 1);
    gl.ClearDepthf(1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::State::use(ShaderProgram& program, const BlockViews& blocks) {
    gl.UseProgram(program.name());
    program.feed(blocks);
    for (GLuint location = 0, changed = enabledAttributes ^ program.attributes(); changed != 0;
         ++location, changed >>= 1)
        if ((changed & 1u) != 0)
            (program.attributes() >> location & 1u) != 0 ? gl.EnableVertexAttribArray(location)
                                                         : gl.DisableVertexAttribArray(location);
    enabledAttributes = program.attributes();
}

void Renderer::State::drawOne(const Drawable& drawable) {
    const GpuMaterial& material = scene.materials[drawable.material];
    use(*material.program, {frame.view(), lights.view(), material.block.view(), drawable.block.view()});
    for (const Sampler& sampler : material.program->interface().samplers) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(sampler.unit));
        gl.BindTexture(GL_TEXTURE_2D, material.textures[static_cast<std::size_t>(sampler.unit)]);
    }
    drawable.doubleSided ? gl.Disable(GL_CULL_FACE) : gl.Enable(GL_CULL_FACE);
    gl.FrontFace(drawable.mirrored ? GL_CW : GL_CCW);
    scene.meshes[drawable.mesh].draw(gl, material.program->attributes(), material.plan.uvSets);
}

void Renderer::State::drawBackdrop() {
    use(*skyProgram, {frame.view(), lights.view(), {}, {}});
    gl.ActiveTexture(GL_TEXTURE0 + kSkyUnit);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, sky.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, skyTriangle.name());
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.Disable(GL_CULL_FACE);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::State::drawBlended(const Viewpoint& viewpoint) {
    const auto depth = [&](std::size_t index) {
        return glm::dot(scene.drawables[index].center - viewpoint.eye, viewpoint.forward);
    };
    std::stable_sort(blended.begin(), blended.end(),
                     [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
    gl.Enable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    for (const std::size_t index : blended)
        drawOne(scene.drawables[index]);
    gl.DepthMask(GL_TRUE);
}

Renderer::Renderer(const Gl& gl, Log log) : Renderer(gl, Capabilities::query(gl), std::move(log)) {}

Renderer::Renderer(const Gl& gl, const Capabilities& capabilities, Log log)
    : m_state(std::make_unique<State>(gl, capabilities, std::move(log))) {}

Renderer::~Renderer() = default;

namespace {

/// After an upload; GL's other errors are bugs.
Result<void> checkMemory(const Gl& gl) {
    for (GLenum error = gl.GetError(); error != GL_NO_ERROR; error = gl.GetError())
        if (error == GL_OUT_OF_MEMORY)
            return Error{"renderer.memory", "", "the GPU's memory does not suffice",
                         "use smaller textures, or raise the memory that the GPU gets"};
    return {};
}

} // namespace

Result<void> Renderer::load(const Scene& scene) {
    State& state = *m_state;
    state.scene = upload(state.gl, scene, state.defaults, state.capabilities, state.log);
    state.opaque.clear();
    state.blended.clear();
    for (std::size_t i = 0; i < state.scene.drawables.size(); ++i)
        (state.scene.drawables[i].blended ? state.blended : state.opaque).push_back(i);
    state.resolved = false;
    return checkMemory(state.gl);
}

Result<void> Renderer::setBackdrop(const SkyCube* cube) {
    State& state = *m_state;
    state.resolved = false;
    state.sky = {};
    if (cube == nullptr)
        return {};
    state.skyRange = cube->range;
    state.sky = uploadCube(state.gl, *cube);
    constexpr float kTriangle[] = {-1, -1, 1, 3, -1, 1, -1, 3, 1};
    state.skyTriangle = GlBuffer(state.gl, generate(state.gl.GenBuffers));
    state.gl.BindBuffer(GL_ARRAY_BUFFER, state.skyTriangle.name());
    state.gl.BufferData(GL_ARRAY_BUFFER, sizeof(kTriangle), kTriangle, GL_STATIC_DRAW);
    return checkMemory(state.gl);
}

void Renderer::setLighting(const Lighting& lighting) {
    m_state->resolved = m_state->resolved && sameShape(m_state->lighting, lighting);
    m_state->lighting = lighting;
}

void Renderer::setLook(const Look& look) {
    m_state->look = look;
    m_state->resolved = false;
}

Result<void> Renderer::prepare() { return m_state->resolvePrograms(); }

Result<void> Renderer::draw(const Viewpoint& viewpoint, const DrawTarget& target) {
    State& state = *m_state;
    if (Result<void> resolved = state.resolvePrograms(); !resolved)
        return resolved;
    state.updateBlocks(viewpoint, target);
    state.beginFrame(target);
    for (const std::size_t index : state.opaque)
        state.drawOne(state.scene.drawables[index]);
    if (state.sky)
        state.drawBackdrop();
    state.drawBlended(viewpoint);
    return {};
}

const ProgramCounters& Renderer::programCounters() const { return m_state->cache.counters(); }

} // namespace franken
