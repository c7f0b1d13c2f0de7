// SPDX-License-Identifier: MIT
// What a program reads.
#include "frame_price.h"

#include <nlohmann/json.hpp>

using namespace franken;

namespace price {
namespace {

using Json = nlohmann::ordered_json;

Json toDocument(const ProgramBill& bill, const SnippetSet& snippets) {
    Json json = {{"name", toName(bill.program, snippets)},
                 {"pixels", bill.shaded.pixels},
                 {"quads", bill.shaded.quads},
                 {"vertices", bill.vertices},
                 {"tileVertices", bill.tileVertices},
                 {"known", std::string(toString(bill.cost.known))}};
    if (!bill.cost.error.empty()) {
        json["error"] = bill.cost.error;
        return json;
    }
    json["instructions"] = {
        {"fragment", bill.cost.fragment}, {"vertex", bill.cost.vertex}, {"coordinate", bill.cost.coordinate}};
    json["threads"] = bill.cost.threads > 0 ? Json(bill.cost.threads) : Json();
    json["milliseconds"] = {{"pixels", bill.fragmentMilliseconds}, {"vertices", bill.vertexMilliseconds}};
    return json;
}

Json toDocument(const FrameBill& bill) {
    const bool knowsUnits = bill.machine.gpu.texelsPerClock > 0;
    return {{"machine", std::string(bill.machine.model.word)},
            {"name", std::string(bill.machine.model.name)},
            {"gpu", std::string(bill.machine.gpu.name)},
            {"megahertz", bill.machine.model.megahertz},
            {"milliseconds",
             {{"least", bill.least()},
              {"most", bill.most()},
              {"pixels", bill.pixels},
              {"vertices", bill.vertices},
              {"textureUnits", knowsUnits ? Json(bill.textureUnits) : Json()},
              {"memory", bill.memory}}},
            {"bytes",
             {{"texels", bill.traffic.texels},
              {"vertices", bill.traffic.vertices},
              {"stores", bill.traffic.stores}}},
            {"bound", std::string(toString(bill.bound()))}};
}

} // namespace

std::string toJson(const FramePrice& price, const SnippetSet& snippets) {
    Json json = {{"schema", 1},
                 {"width", price.width},
                 {"height", price.height},
                 {"compiled", price.whyNotCompiled.empty()}};
    json["machines"] = Json::array();
    for (const FrameBill& bill : price.bills) {
        Json document = toDocument(bill);
        document["programs"] = Json::array();
        for (const ProgramBill& program : bill.programs)
            document["programs"].push_back(toDocument(program, snippets));
        json["machines"].push_back(std::move(document));
    }
    json["changes"] = Json::array();
    for (const Change& change : price.changes)
        json["changes"].push_back({{"change", change.words},
                                   {"machine", std::string(change.bill.machine.model.word)},
                                   {"least", change.bill.least()},
                                   {"most", change.bill.most()}});
    return json.dump(1) + "\n";
}

} // namespace price
