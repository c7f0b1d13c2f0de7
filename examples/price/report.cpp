// SPDX-License-Identifier: MIT
// What a person reads.
#include "frame_price.h"

#include <algorithm>
#include <cstdio>
#include <map>

using namespace franken;

namespace price {
namespace {

constexpr double kFrameAt60Hz = 1000.0 / 60;

template<typename... Values>
std::string formatted(const char* format, Values... values) {
    std::string text(static_cast<std::size_t>(std::max(0, std::snprintf(nullptr, 0, format, values...))),
                     ' ');
    std::snprintf(text.data(), text.size() + 1, format, values...);
    return text;
}

std::string pixelsLine(const FramePrice& price, const FrameBill& bill) {
    Shaded shaded;
    std::size_t vertices = 0, tileVertices = 0;
    for (const ProgramBill& program : bill.programs) {
        shaded += program.shaded;
        vertices += program.vertices;
        tileVertices += program.tileVertices;
    }
    const double target = static_cast<double>(price.width) * price.height;
    return formatted(
        "%dx%d on a %s: %zu pixels are shaded (%.2f of the target) in %zu blocks of 2x2; %zu vertices "
        "(%zu tile by tile)\n",
        price.width, price.height, std::string(bill.machine.model.name).c_str(), shaded.pixels,
        static_cast<double>(shaded.pixels) / target, shaded.quads, vertices, tileVertices);
}

std::string instructionsOf(const ProgramCost& cost) {
    if (!cost.error.empty())
        return cost.error;
    const char* mark = cost.known == Known::Interpolated ? "~" : "";
    const std::string threads =
        cost.threads > 0 ? formatted(", %d thread%s", cost.threads, cost.threads == 1 ? "" : "s") : "";
    return formatted("%s%d a pixel, %s%d a vertex%s", mark, cost.fragment, mark,
                     cost.vertex + cost.coordinate, threads.c_str());
}

std::string programLines(const FrameBill& bill, const SnippetSet& snippets) {
    std::string text;
    for (const ProgramBill& program : bill.programs)
        text +=
            formatted("%8.2f ms %9zu pixels  %s\n", program.fragmentMilliseconds + program.vertexMilliseconds,
                      program.shaded.pixels, instructionsOf(program.cost).c_str()) +
            "            " + toName(program.program, snippets) + "\n";
    return text;
}

std::string sourceLine(const FramePrice& price) {
    std::map<Known, int> counted;
    for (const ProgramBill& program : price.bills[price.asked].programs)
        ++counted[program.cost.known];
    if (price.whyNotCompiled.empty())
        return "instructions: counted here by the compilers of these GPUs\n";
    return formatted(
        "instructions: of %d programs from the table of measured ones, of %d interpolated (~), because %s\n",
        counted[Known::Table], counted[Known::Interpolated], price.whyNotCompiled.c_str());
}

// What the GPU cannot run is drawn by a simpler program, which is not in the bill.
const char* verdict(const FrameBill& bill) {
    const bool isWhole = std::all_of(bill.programs.begin(), bill.programs.end(),
                                     [](const ProgramBill& program) { return program.cost.error.empty(); });
    if (bill.least() > kFrameAt60Hz)
        return "no";
    return !isWhole ? "unknown" : bill.most() <= kFrameAt60Hz ? "yes" : "perhaps";
}

std::string machineLines(const FramePrice& price) {
    std::string text =
        "                  pixels  vertices  textures   memory    frame            60 Hz     bound by\n";
    for (const FrameBill& bill : price.bills) {
        const std::string textures =
            bill.machine.gpu.texelsPerClock > 0 ? formatted("%8.2f", bill.textureUnits) : "       -";
        text += formatted("%-16s%8.2f  %8.2f  %s %8.2f  %6.1f-%5.1f ms  %-8s  %s\n",
                          std::string(bill.machine.model.name).c_str(), bill.pixels, bill.vertices,
                          textures.c_str(), bill.memory, bill.least(), bill.most(), verdict(bill),
                          std::string(toString(bill.bound())).c_str());
    }
    return text;
}

std::string changeLines(const FramePrice& price) {
    const FrameBill& before = price.bills[price.asked];
    const std::string name(before.machine.model.name);
    if (price.changes.empty())
        return "on a " + name + " no change of the options brings more than a hundredth\n";
    std::string text = formatted("on a %s these would bring most, of %.1f-%.1f ms:\n", name.c_str(),
                                 before.least(), before.most());
    for (const Change& change : price.changes)
        text += formatted("  %-40s %6.1f-%5.1f ms\n", change.words.c_str(), change.bill.least(),
                          change.bill.most());
    return text;
}

} // namespace

std::string toText(const FramePrice& price, const SnippetSet& snippets) {
    const FrameBill& asked = price.bills[price.asked];
    return pixelsLine(price, asked) + programLines(asked, snippets) + sourceLine(price) + "\n" +
           machineLines(price) +
           "Milliseconds are estimates: the least is as if all parts ran beside each other, the most as if "
           "none did.\n\n" +
           changeLines(price);
}

} // namespace price
