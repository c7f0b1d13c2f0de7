// SPDX-License-Identifier: MIT
#include "cost_json.h"

#include "json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace franken::cli {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const ShaderCost& shader) {
    return {{"instructions", shader.instructions},
            {"threads", shader.threads},
            {"uniforms", shader.uniforms},
            {"temps", shader.temps},
            {"spills", shader.spills},
            {"fills", shader.fills}};
}

Json modelsOf(const Gpu& gpu, int instructions) {
    Json models = Json::array();
    for (const PiModel& model : gpu.models)
        models.push_back({{"model", model.name},
                          {"megahertz", model.megahertz},
                          {"megapixelsPerSecond", megapixelsPerSecond(gpu, model, instructions)}});
    return models;
}

Json toJson(const Gpu& gpu, const Priced& priced) {
    Json json = {{"name", toName(priced.asked)}, {"gpu", gpu.name}, {"measured", toName(priced.measured)}};
    if (!priced.cost.measured()) {
        json["error"] = priced.cost.error;
        return json;
    }
    json["fragment"] = toJson(priced.cost.fragment);
    json["vertex"] = toJson(priced.cost.vertex);
    json["coordinate"] = toJson(priced.cost.coordinate);
    json["atMost"] = modelsOf(gpu, priced.cost.fragment.instructions);
    // Null: they never pay. Without the member, there is one way only.
    if (priced.breakEven)
        json["vertexLightPaysFromPixels"] = std::isinf(*priced.breakEven) ? Json() : Json(*priced.breakEven);
    return json;
}

} // namespace

std::string costJson(const std::vector<Bill>& bills) {
    Json json = {{"schema", kJsonSchema}, {"command", "cost"}, {"costs", Json::array()}};
    for (const Bill& bill : bills)
        for (const Priced& priced : bill.priced)
            json["costs"].push_back(toJson(bill.gpu, priced));
    return json.dump(2) + "\n";
}

} // namespace franken::cli
