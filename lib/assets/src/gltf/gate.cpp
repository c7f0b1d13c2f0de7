// SPDX-License-Identifier: MIT
#include "gltf/gate.h"

namespace franken::gltf {
namespace {

constexpr std::size_t kMaxDepth = 64;

// What one value takes at most while it is in a document of nlohmann-json, and then in tinygltf's: a node of
// a map with its key, or a place in a growing array, which also costs more time than it takes memory.
constexpr std::size_t kMemberBytes = 160, kElementBytes = 96;

/// Reads the text without building anything from it, and stops where it goes too far. nlohmann-json's parser
/// keeps its own stack, so depth does no harm to it.
class Gate : public Json::json_sax_t {
public:
    explicit Gate(Source& source) : m_source(source) {}

    bool null() override { return charge(kElementBytes); }
    bool boolean(bool) override { return charge(kElementBytes); }
    bool number_integer(number_integer_t) override { return charge(kElementBytes); }
    bool number_unsigned(number_unsigned_t) override { return charge(kElementBytes); }
    bool number_float(number_float_t, const string_t&) override { return charge(kElementBytes); }
    bool string(string_t&) override { return charge(kElementBytes); }
    bool binary(binary_t&) override { return charge(kElementBytes); }
    bool key(string_t&) override { return charge(kMemberBytes); }
    bool start_object(std::size_t) override { return enter(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }

    bool parse_error(std::size_t position, const std::string&, const Json::exception& exception) override {
        return m_source.fail("gltf.json", "byte " + std::to_string(position), exception.what(),
                             "check that the file is a .gltf or .glb, and complete");
    }

private:
    bool charge(std::size_t bytes) { return m_source.charge(1, bytes, "the JSON"); }
    bool leave() { return m_depth-- > 0; }
    bool enter() {
        if (++m_depth > kMaxDepth)
            return m_source.fail("gltf.limit", "the JSON",
                                 "it is nested more than " + std::to_string(kMaxDepth) + " deep",
                                 "leave out what glTF does not need: it nests less than 20 deep");
        return charge(kMemberBytes);
    }

    Source& m_source;
    std::size_t m_depth = 0;
};

} // namespace

bool checkJson(Source& source) {
    // The parser keeps a string three times: as read, as decoded, and in the document.
    if (!source.charge(source.jsonText.size(), 3, "the JSON"))
        return false;
    Gate gate(source);
    return Json::sax_parse(source.jsonText.begin(), source.jsonText.end(), &gate);
}

} // namespace franken::gltf
