// SPDX-License-Identifier: MIT
#include "frame_price.h"

#include "changes.h"

#include <algorithm>
#include <utility>

using namespace franken;

namespace price {
namespace {

/// Each program once, and where it is.
class ProgramList {
public:
    void add(std::span<const Permutation> programs) {
        for (const Permutation& program : programs)
            if (std::find(m_programs.begin(), m_programs.end(), program) == m_programs.end())
                m_programs.push_back(program);
    }

    Result<void> price(const ProgramCosts& costs, const cli::Gpu& gpu, const SnippetSet& snippets) {
        return costs.of(gpu, m_programs, snippets).transform([this](std::vector<ProgramCost> found) {
            m_costs = std::move(found);
        });
    }

    std::vector<ProgramCost> costsOf(std::span<const Permutation> programs) const {
        std::vector<ProgramCost> costs;
        for (const Permutation& program : programs)
            costs.push_back(m_costs[static_cast<std::size_t>(
                std::find(m_programs.begin(), m_programs.end(), program) - m_programs.begin())]);
        return costs;
    }

private:
    std::vector<Permutation> m_programs;
    std::vector<ProgramCost> m_costs;
};

Result<std::vector<FrameBill>> billsOn(const cli::Gpu& gpu, const FrameCounts& counts, const Terms& terms,
                                       const ProgramCosts& costs, const SnippetSet& snippets) {
    const Result<std::vector<Permutation>> programs = programsOf(counts, terms);
    if (!programs)
        return programs.error();
    ProgramList list;
    list.add(*programs);
    if (Result<void> priced = list.price(costs, gpu, snippets); !priced)
        return priced.error();
    std::vector<FrameBill> bills;
    for (const cli::PiModel& model : gpu.models)
        bills.push_back(billOf(counts, terms, {gpu, model}, *programs, list.costsOf(*programs)));
    return bills;
}

/// All offers on that machine, priced in one run of the compiler.
Result<std::vector<Change>> changesOn(const Machine& machine, const FrameCounts& counts, const Terms& terms,
                                      const ProgramCosts& costs, const SnippetSet& snippets) {
    const std::vector<Offer> offers = offersFor(terms);
    std::vector<std::vector<Permutation>> programs;
    ProgramList list;
    for (const Offer& offer : offers) {
        Result<std::vector<Permutation>> changed = programsOf(counts, offer.terms);
        if (!changed)
            return changed.error();
        list.add(*changed);
        programs.push_back(*std::move(changed));
    }
    if (Result<void> priced = list.price(costs, machine.gpu, snippets); !priced)
        return priced.error();
    std::vector<Change> changes;
    for (std::size_t i = 0; i < offers.size(); ++i)
        changes.push_back({offers[i].words,
                           billOf(counts, offers[i].terms, machine, programs[i], list.costsOf(programs[i]))});
    return changes;
}

/// Between the least and the most.
double middleOf(const FrameBill& bill) { return (bill.least() + bill.most()) / 2; }

/// Those that bring more than a hundredth of the frame and whose programs the GPU can run, the best first.
std::vector<Change> bestOf(std::vector<Change> changes, const FrameBill& before) {
    std::erase_if(changes, [&](const Change& change) {
        const bool runs = std::all_of(change.bill.programs.begin(), change.bill.programs.end(),
                                      [](const ProgramBill& bill) { return bill.cost.error.empty(); });
        return !runs || middleOf(change.bill) > 0.99 * middleOf(before);
    });
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return middleOf(a.bill) < middleOf(b.bill); });
    if (changes.size() > kMostChanges)
        changes.erase(changes.begin() + kMostChanges, changes.end());
    return changes;
}

} // namespace

std::vector<std::string> machineWords() {
    std::vector<std::string> words;
    for (const Machine& machine : machines())
        words.emplace_back(machine.model.word);
    std::sort(words.begin(), words.end());
    return words;
}

Result<FramePrice> priceFrame(const FrameContents& frame, std::string_view machine, const ProgramCosts& costs,
                              const SnippetSet& snippets) {
    const Result<FrameCounts> counts = countFrame(frame);
    if (!counts)
        return counts.error();
    const Terms terms{frame.lighting, frame.look};
    FramePrice price{.width = frame.width,
                     .height = frame.height,
                     .bills = {},
                     .changes = {},
                     .whyNotCompiled = costs.whyNotCompiled()};
    for (const cli::Gpu& gpu : cli::gpus()) {
        Result<std::vector<FrameBill>> bills = billsOn(gpu, *counts, terms, costs, snippets);
        if (!bills)
            return bills.error();
        for (FrameBill& bill : *bills) {
            if (bill.machine.model.word == machine)
                price.asked = price.bills.size();
            price.bills.push_back(std::move(bill));
        }
    }
    const FrameBill& asked = price.bills[price.asked];
    Result<std::vector<Change>> changes = changesOn(asked.machine, *counts, terms, costs, snippets);
    if (!changes)
        return changes.error();
    price.changes = bestOf(*std::move(changes), asked);
    return price;
}

} // namespace price
