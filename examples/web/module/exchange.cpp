// SPDX-License-Identifier: MIT
#include "exchange.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace franken::web {
namespace {

// Of doubles, so that numbers in it are aligned.
std::vector<double> g_input;
std::size_t g_size = 0;
std::string g_answer;

} // namespace

std::span<const std::uint8_t> input() {
    return {reinterpret_cast<const std::uint8_t*>(g_input.data()), g_size};
}

std::string_view inputText(std::size_t size) {
    return {reinterpret_cast<const char*>(g_input.data()), std::min(size, g_size)};
}

std::span<const double> inputNumbers(std::size_t count) {
    if (g_input.size() < count)
        g_input.resize(count);
    return std::span<const double>(g_input).first(count);
}

void answer(const Json& json) { g_answer = json.text(); }
void answer(std::string text) { g_answer = std::move(text); }

void answer(const Error& error) {
    Json json;
    json.begin('{');
    writeError(json, error);
    answer(json.end('}'));
}

void writeError(Json& json, const Error& error) {
    json.key("error").begin('{').member("code", error.code).member("where", error.where);
    json.member("what", error.what).member("remedy", error.remedy).member("text", toString(error)).end('}');
}

} // namespace franken::web

/// Makes room for `size` bytes of the page, and says where.
FRANKEN_EXPORT(reserve) void* reserveInput(std::size_t size) {
    franken::web::g_input.assign(size / sizeof(double) + 1, 0);
    franken::web::g_size = size;
    return franken::web::g_input.data();
}

/// The last answer, UTF-8.
FRANKEN_EXPORT(answerData) const char* answerData() { return franken::web::g_answer.data(); }
FRANKEN_EXPORT(answerSize) std::size_t answerSize() { return franken::web::g_answer.size(); }
