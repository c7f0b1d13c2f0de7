// SPDX-License-Identifier: MIT
#include "frame.h"

#include "checked_upload.h"
#include "object_block.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace franken {
namespace {

/// Whether one light may follow the other without other programs and other material blocks.
bool sameShape(const Lighting& a, const Lighting& b) {
    const auto spots = [](const Lighting& lighting) {
        return std::any_of(lighting.punctualLights.begin(), lighting.punctualLights.end(),
                           [](const PunctualLight& light) { return light.spot; });
    };
    return a.suns.size() == b.suns.size() && a.punctualLights.size() == b.punctualLights.size() &&
           spots(a) == spots(b) && a.ambient.kind == b.ambient.kind && a.reflection == b.reflection &&
           a.exposure == b.exposure;
}

/// Whether the vertices are those of the pose already. Morph targets alone do not see where joints are: for
/// them, a new pose with the same weights is the same one.
bool isMovedTo(const Deforming& pose, unsigned poses, const std::optional<PoseSource>& source) {
    const bool withJoints = !pose.joints.empty();
    if (!source || source->withJoints != withJoints)
        return false;
    return source->pose == poses ||
           (!withJoints && std::equal(pose.weights.begin(), pose.weights.end(), source->weights.begin(),
                                      source->weights.end()));
}

} // namespace

void Frame::setLighting(const Lighting& lighting) {
    m_resolved = m_resolved && sameShape(m_lighting, lighting);
    m_lighting = lighting;
}

void Frame::setLook(const Look& look) {
    m_look = look;
    m_resolved = false;
}

Result<void> Frame::resolvePrograms(const DrawTarget* target) {
    if (m_modelRevision != m_content.models.revision()) {
        m_list.rebuild(m_content.models.shown());
        m_modelRevision = m_content.models.revision();
        m_resolved = false;
    }
    if (m_resolved)
        return {};
    FirstError first;
    m_device.state.invalidate(); // Compiling a program uses it.
    m_resolved = true;
    for (GpuMaterial* material : m_list.materials())
        first.add(resolveMaterial(*material, target));
    if (m_content.skybox.isShown())
        first.add(resolveSkybox(target));
    m_list.sort();
    return first.take();
}

Result<ProgramHandle> Frame::resolve(const Result<Permutation>& permutation, const DrawState& state,
                                     const DrawTarget* target) {
    if (!permutation)
        return permutation.error();
    // A program is proved by drawing with it: not on a picture that is to stay.
    const bool isErased = target != nullptr && !target->area && target->clear == Clear::ColorAndDepth;
    const Result<ProgramManager::Supplied> supplied =
        m_programs.get({*permutation, state}, isErased ? target : nullptr);
    if (!supplied)
        return supplied.error();
    m_resolved = m_resolved && !supplied->standIn;
    return supplied->program;
}

Result<void> Frame::resolveMaterial(GpuMaterial& material, const DrawTarget* target) {
    material.program = nullptr;
    const Result<ProgramHandle> program =
        resolve(permutationOf(material.plan, m_lighting, m_look), material.state, target);
    if (!program)
        return program.error();
    material.program = *program;
    material.isPacked = false;
    return {};
}

bool Frame::makeProgram(GpuScene& scene) {
    const unsigned before = m_programs.counters().links;
    m_device.state.invalidate(); // Compiling a program uses it.
    for (GpuMaterial& material : scene.materials) {
        if (!material.program)
            static_cast<void>(resolveMaterial(material, nullptr));
        if (m_programs.counters().links != before)
            return true;
    }
    return false;
}

Result<void> Frame::resolveSkybox(const DrawTarget* target) {
    m_skyboxProgram = nullptr;
    return resolve(skyPermutation(m_look), {}, target).transform([this](ProgramHandle program) {
        m_skyboxProgram = std::move(program);
    });
}

void Frame::updateBlocks(const PlacedView& view, const DrawTarget& target) {
    FrameBlock values{};
    values.cameraPosition = {0, 0, 0}; // Because objects are placed as seen from it.
    roundTo(values.clipToSky, view.skyFromWorld * view.viewpoint.clipToSky);
    values.skyRange = m_content.skybox.range() * m_lighting.exposure;
    values.reflectionScale = std::sqrt(m_content.reflection.range() * m_lighting.exposure);
    values.dither = packDither(target.bits);
    LightsBlock lights = packLighting(m_lighting, view.viewpoint.eye);
    if (m_look.precision == Precision::Fp16) {
        const float farthest = static_cast<float>(m_list.farthest(view.viewpoint.eye));
        values.lengthScale = lengthScaleFp16(farthest);
        values.lengthUnit = 1 / values.lengthScale;
        values.skyRange = std::min(values.skyRange, kMostFp16);
        fitToFp16(lights, farthest);
    }
    m_frame.set(values);
    m_lights.set(lights);
    for (GpuMaterial* material : m_list.materials())
        if (!std::exchange(material->isPacked, true)) {
            MaterialBlock& block = material->block.edit();
            block = packMaterial(material->plan.factors, m_look.brdf, m_lighting.exposure, m_look.precision);
            block.uv = material->plan.uvTransforms;
        }
}

// A picture of normals shows those of the world.
PlacedView Frame::viewFrom(const Viewpoint& viewpoint, Rotation rotation) const {
    return {turned(viewpoint, rotation),
            m_look.view == View::Normal ? glm::dmat3(1.0) : skyFromWorld(m_lighting)};
}

void Frame::begin(const DrawTarget& target) {
    GlState& state = m_device.state;
    m_device.begin(target);
    state.setBlending(false);
    state.setDepthTest(true);
    state.setDepthWrites(true);
    state.setDepthRange(0, 1);
    m_content.reflection.bind(state);
    clear(target);
    m_boundMaterial = nullptr;
}

void Frame::clear(const DrawTarget& target) {
    if (target.clear == Clear::Nothing)
        return;
    const Float3& color = target.background;
    m_device.state.setClearColor({color[0], color[1], color[2], target.backgroundAlpha});
    if (target.area) {
        m_device.state.setScissorTest(true);
        m_device.gl.Scissor(target.area->x, target.area->y, target.area->width, target.area->height);
    }
    m_device.gl.Clear(target.clear == Clear::Depth ? GL_DEPTH_BUFFER_BIT
                                                   : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    m_device.state.setScissorTest(false);
}

Result<void> Frame::moveVertices() {
    FirstError first;
    m_list.forEachDeformed([&](Object& object) { first.add(moveVertices(object)); });
    return first.take();
}

// What a program moves to its joints is moved here by morph targets alone, and what is at rest already by
// nothing.
Result<void> Frame::moveVertices(Object& object) {
    object.posed = nullptr;
    Deforming pose = deformingOf(object);
    const bool byProgram = isSkinnedByProgram(object);
    if (byProgram) {
        pose.joints = {};
        if (std::all_of(pose.weights.begin(), pose.weights.end(), [](float weight) { return weight == 0; }))
            return {};
    } else if (!object.mesh->isSkinned() && !isPosed(object)) {
        return {};
    }
    const Place& place = *object.place;
    GpuScene& scene = *place.model->gpu;
    const auto drawable = static_cast<std::size_t>(object.drawable - scene.drawables.data());
    return moveVertices(object, pose, scene.posed[{place.id, drawable}]);
}

Result<void> Frame::moveVertices(Object& object, const Deforming& pose, PosedMesh& posed) {
    if (posed.vertices.empty()) {
        Result<PosedMesh> made = checkedUpload(m_device, [&] { return object.mesh->makePosed(m_device); });
        if (!made)
            return made.error();
        posed = *std::move(made);
    }
    object.posed = &posed;
    if (isMovedTo(pose, object.place->poses, posed.source))
        return {};
    deform(*object.primitive->deformation, pose, m_moved);
    object.mesh->upload(m_device, m_moved, posed);
    if (!posed.source)
        posed.source.emplace();
    posed.source->pose = object.place->poses;
    posed.source->withJoints = !pose.joints.empty();
    posed.source->weights.assign(pose.weights.begin(), pose.weights.end());
    return {};
}

Result<void> Frame::draw(const Viewpoint& viewpoint, const DrawTarget& target) {
    const PlacedView view = viewFrom(viewpoint, target.rotation);
    m_list.place(view, m_content.models.movements());
    updateBlocks(view, target);
    m_counters = {.drawn = m_list.visible(), .culled = m_list.size() - m_list.visible()};
    Result<void> moved = moveVertices();
    begin(target);
    drawOpaque();
    drawSkybox();
    drawBlended();
    return moved;
}

void Frame::use(ShaderProgram& program, const BlockViews& blocks) {
    m_programs.prepareDraw(m_device.state, program);
    m_device.state.useProgram(program.name());
    program.feed(blocks);
    m_device.state.enableArrays(program.attributes());
}

void Frame::bind(const GpuMaterial& material) {
    use(*material.program, {m_frame.view(), m_lights.view(), material.block.view()});
    for (const Sampler& sampler : material.program->interface().samplers)
        if (const auto unit = static_cast<std::size_t>(sampler.unit); isMaterialsUnit(unit))
            m_device.state.bindTexture(static_cast<unsigned>(unit), GL_TEXTURE_2D, material.textures[unit]);
    m_boundMaterial = &material;
}

void Frame::drawOne(const Object& object) {
    if (object.mesh->isSkinned() && !isSkinnedByProgram(object) && object.posed == nullptr)
        return; // There was no room for its moved vertices.
    const GpuMaterial& material = *object.material;
    if (m_boundMaterial != &material)
        bind(material);
    ShaderProgram& program = *material.program;
    program.feed(Block::Object, {reinterpret_cast<const float*>(&object.block), object.serial});
    if (m_look.effect.slot != 0)
        program.feed(Block::User, object.place->effect ? object.place->effect->view() : m_effect.view());
    m_device.state.setCulling(!material.doubleSided || material.state.blend);
    m_device.state.setFrontFace(object.mirrored ? GL_CW : GL_CCW);
    for (std::size_t part = 0; part < object.mesh->parts(); ++part) {
        if (isSkinnedByProgram(object))
            feedPalette(program, object, part);
        object.mesh->draw(part, m_device.gl, m_device.state, program.attributes(), material.plan.uvSets,
                          object.posed);
    }
}

void Frame::feedPalette(ShaderProgram& program, const Object& object, std::size_t part) {
    const std::uint64_t serial = object.paletteSerial + part;
    if (std::exchange(m_skinSerial, serial) != serial) {
        Float4* row = m_skin.joints.data();
        const std::vector<glm::mat4x3>& joints = object.palette.joints;
        for (const std::uint32_t joint : object.mesh->jointsOf(part)) {
            const glm::mat3x4 rows = glm::transpose(joints.empty() ? glm::mat4x3(1.0f) : joints[joint]);
            for (int axis = 0; axis < 3; ++axis)
                std::copy_n(glm::value_ptr(rows[axis]), 4, (row++)->begin());
        }
    }
    program.feed(Block::Skin, {reinterpret_cast<const float*>(&m_skin), serial});
}

// Through a transparent surface its other side is seen, which therefore comes first.
void Frame::drawSides(const Object& object) {
    if (!object.material->doubleSided)
        return drawOne(object);
    for (const GLenum culled : {GL_FRONT, GL_BACK}) {
        m_device.state.setCulledFace(culled);
        drawOne(object);
    }
}

void Frame::drawOpaque() {
    for (const DrawList::Layer& layer : m_list.frontToBack())
        drawOne(*layer.object);
}

void Frame::drawSkybox() {
    if (!m_content.skybox.isShown() || !m_skyboxProgram)
        return;
    use(*m_skyboxProgram, {m_frame.view(), m_lights.view()});
    m_content.skybox.draw(m_device.state);
}

void Frame::drawBlended() {
    if (m_list.backToFront().empty())
        return;
    m_device.state.setBlending(true);
    m_device.state.setDepthWrites(false);
    m_boundMaterial = nullptr; // The skybox's program may be in use.
    for (const Object* object : m_list.backToFront())
        drawSides(*object);
}

void Frame::lost() {
    m_list.clear();
    m_skyboxProgram.reset();
    m_resolved = false;
    m_counters = {};
}

} // namespace franken
