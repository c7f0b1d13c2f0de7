// SPDX-License-Identifier: MIT
#include "frame_bill.h"

#include "texels.h"

#include <algorithm>
#include <utility>

using namespace franken;

namespace price {
namespace {

/// Texels of the sky's reflection that a pixel brings from memory: one of each of the two levels that it
/// mixes. The irradiance and the lookup are small enough to stay in the cache. An estimate.
constexpr double kReflectionTexels = 2;

/// Texture fetches of the reflection: two levels, the irradiance, the lookup (lib/assets' reflection.h).
constexpr double kReflectionLookups = 4;

constexpr double kPositionBytes = 12;
constexpr double kPixelsOfAQuad = 4;
constexpr double kLanes = 4; ///< Of a QPU: see cli::Gpu.

bool reflects(const Permutation& program) { return program.reflection != Reflection::None; }

/// Milliseconds of so many instructions, each of them for one pixel or vertex.
double millisecondsOf(double instructions, const Machine& machine) {
    return instructions / (machine.gpu.qpus * kLanes * machine.model.megahertz * 1000.0);
}

ProgramBill& entryOf(std::vector<ProgramBill>& bills, const Permutation& program, const ProgramCost& cost) {
    const auto found = std::find_if(bills.begin(), bills.end(),
                                    [&](const ProgramBill& bill) { return bill.program == program; });
    if (found != bills.end())
        return *found;
    bills.push_back({program, cost, {}});
    return bills.back();
}

void addTo(ProgramBill& bill, const Draw& draw, const Shaded& shaded, const Machine& machine) {
    const ProgramCost& cost = bill.cost;
    const auto quads = static_cast<double>(shaded.quads), vertices = static_cast<double>(draw.vertices),
               tileVertices = static_cast<double>(draw.tileVertices);
    bill.shaded += shaded;
    bill.vertices += draw.vertices;
    bill.tileVertices += draw.tileVertices;
    bill.lookups += static_cast<double>(shaded.pixels) *
                    (draw.lookups + (reflects(bill.program) ? kReflectionLookups : 0));
    bill.fragmentMilliseconds += millisecondsOf(kPixelsOfAQuad * quads * cost.fragment, machine);
    bill.vertexMilliseconds +=
        millisecondsOf(vertices * cost.coordinate + tileVertices * cost.vertex, machine);
}

/// Where all is shaded that is covered, the texels of the hidden pixels come as well.
double texelsOf(const Draw& draw, const Shaded& shaded, const Permutation& program, bool halved) {
    const auto pixels = static_cast<double>(shaded.pixels), tested = static_cast<double>(draw.shaded.pixels);
    const double bytes = halved ? draw.texels.halved : draw.texels.whole;
    return (tested > 0 ? bytes * pixels / tested : 0) +
           (reflects(program) ? kTexelBytes * kReflectionTexels * pixels : 0);
}

EarlyDepth earlyDepthOf(const cli::Gpu& gpu) {
    return gpu.target == Target::Vc4 ? EarlyDepth::Always : EarlyDepth::UntilDiscard;
}

} // namespace

std::vector<Machine> machines() {
    std::vector<Machine> all;
    for (const cli::Gpu& gpu : cli::gpus())
        for (const cli::PiModel& model : gpu.models)
            all.push_back({gpu, model});
    return all;
}

std::string_view toString(Bound bound) {
    constexpr std::string_view kNames[] = {"pixels", "vertices", "texture units", "memory"};
    return kNames[static_cast<std::size_t>(bound)];
}

double FrameBill::least() const { return std::max({pixels + vertices, textureUnits, memory}); }

Bound FrameBill::bound() const {
    if (memory >= pixels + vertices && memory >= textureUnits)
        return Bound::Memory;
    if (textureUnits >= pixels + vertices)
        return Bound::TextureUnits;
    return pixels >= vertices ? Bound::Pixels : Bound::Vertices;
}

Result<std::vector<Permutation>> programsOf(const FrameCounts& counts, const Terms& terms) {
    std::vector<Permutation> programs;
    for (const Draw& draw : counts.draws) {
        const Result<Permutation> program = programOf(draw, terms.lighting, terms.look);
        if (!program)
            return program.error();
        programs.push_back(*program);
    }
    return programs;
}

FrameBill billOf(const FrameCounts& counts, const Terms& terms, const Machine& machine,
                 std::span<const Permutation> programs, std::span<const ProgramCost> costs) {
    FrameBill bill{.machine = machine, .programs = {}, .traffic = {}};
    const std::vector<Shaded> shaded = shadedOf(counts, earlyDepthOf(machine.gpu));
    double lookups = 0;
    for (std::size_t i = 0; i < counts.draws.size(); ++i) {
        const Draw& draw = counts.draws[i];
        ProgramBill& entry = entryOf(bill.programs, programs[i], costs[i]);
        if (!costs[i].error.empty())
            continue;
        addTo(entry, draw, shaded[i], machine);
        bill.traffic.texels += texelsOf(draw, shaded[i], programs[i], terms.halvedTextures);
        bill.traffic.vertices += static_cast<double>(draw.vertices) * kPositionBytes +
                                 static_cast<double>(draw.tileVertices) * draw.vertexBytes;
    }
    bill.traffic.stores = kTexelBytes * static_cast<double>(counts.width) * counts.height;
    for (const ProgramBill& entry : bill.programs) {
        bill.pixels += entry.fragmentMilliseconds;
        bill.vertices += entry.vertexMilliseconds;
        lookups += entry.lookups;
    }
    if (machine.gpu.texelsPerClock > 0)
        bill.textureUnits = lookups / (machine.gpu.texelsPerClock * machine.model.megahertz * 1000.0);
    bill.memory = bill.traffic.sum() / (kMemoryShare * machine.model.megabytesPerSecond * 1000.0);
    std::stable_sort(bill.programs.begin(), bill.programs.end(),
                     [](const ProgramBill& a, const ProgramBill& b) {
                         return a.fragmentMilliseconds + a.vertexMilliseconds >
                                b.fragmentMilliseconds + b.vertexMilliseconds;
                     });
    return bill;
}

} // namespace price
