// SPDX-License-Identifier: MIT
#include "gltf/schema.h"

#include <algorithm>
#include <array>

#include "gltf/gate.h"

namespace franken::gltf {
namespace {

constexpr std::array<std::string_view, 10> kDescriptions{"true or false",
                                                         "a string",
                                                         "a number",
                                                         "an integer",
                                                         "an integer that is not negative",
                                                         "a size",
                                                         "an index",
                                                         "an object of indices",
                                                         "an object",
                                                         "a name"};

/// Walks a document along the schema. Functions return false after an error.
class Checker {
public:
    explicit Checker(Source& source) : m_source(source) {}

    bool checkObject(Json& object, Schema schema, const std::string& where) {
        if (!object.is_object())
            return wrongType(Kind::Object, where);
        for (auto member = object.begin(); member != object.end();) {
            const auto property = std::find_if(schema.begin(), schema.end(),
                                               [&](const Property& p) { return p.name == member.key(); });
            if (property != schema.end() && member->is_null())
                m_source.warnOnce(kMended, "a null counts as a property that is absent");
            if (property == schema.end() || member->is_null())
                member = object.erase(member);
            else if (checkProperty(*member, *property, where + pathOf(property->name)))
                ++member;
            else
                return false;
        }
        for (const Property& property : schema)
            if (property.required && !object.contains(property.name))
                return m_source.fail("gltf.schema", where,
                                     "the property " + std::string(property.name) + " is missing");
        return true;
    }

private:
    bool checkProperty(Json& value, const Property& property, const std::string& where) {
        if (property.length == kOne)
            return checkValue(value, property, where);
        const bool any = property.length == kMany;
        if (!value.is_array() || (!any && value.size() != property.length))
            return m_source.fail("gltf.schema", where,
                                 "an array is expected here, each element " +
                                     std::string(kDescriptions[static_cast<std::size_t>(property.kind)]) +
                                     (any ? "" : ", of length " + std::to_string(property.length)));
        for (std::size_t i = 0; i < value.size(); ++i)
            if (!checkValue(value[i], property, where + pathOf(i))) {
                if (property.empty.empty() || !m_source.defer(where + pathOf(i)))
                    return false;
                value[i] = Json::parse(property.empty);
            }
        return true;
    }

    bool checkName(Json& value, const std::string& where) {
        if (!value.is_string()) {
            m_source.warn(kMended, where, "a name is a string");
            value = value.is_structured() ? "" : value.dump();
        }
        return true;
    }

    bool checkValue(Json& value, const Property& property, const std::string& where) {
        switch (property.kind) {
        case Kind::Boolean:
            return value.is_boolean() || wrongType(property.kind, where);
        case Kind::String:
            return value.is_string() || wrongType(property.kind, where);
        case Kind::Number:
            return value.is_number() || wrongType(property.kind, where);
        case Kind::Name:
            return checkName(value, where);
        case Kind::Attributes:
            return checkAttributes(value, where);
        case Kind::Object:
            return checkObject(value, property.members, where);
        default:
            return checkInteger(value, property.kind, where);
        }
    }

    // tinygltf cuts integers down to 32 bits, so that an index of 2^32 would be 0.
    bool checkInteger(const Json& value, Kind kind, const std::string& where) {
        if (!value.is_number_integer())
            return wrongType(kind, where);
        const bool isUnsigned = value.is_number_unsigned();
        const bool isSmall = isUnsigned ? value.get<std::uint64_t>() <= std::numeric_limits<int>::max()
                                        : value.get<std::int64_t>() >= std::numeric_limits<int>::min();
        if (kind == Kind::Size ? isUnsigned : isSmall && (isUnsigned || kind == Kind::Integer))
            return true;
        return m_source.fail(
            kind == Kind::Index ? "gltf.index-range" : "gltf.value", where,
            value.dump() + " is out of range: " + std::string(kDescriptions[static_cast<std::size_t>(kind)]) +
                " is expected here");
    }

    bool checkAttributes(Json& object, const std::string& where) {
        if (!object.is_object())
            return wrongType(Kind::Attributes, where);
        for (auto member = object.begin(); member != object.end();) {
            if (!member->is_null() && !checkInteger(*member, Kind::Index, where + pathOf(member.key())))
                return false;
            member = member->is_null() ? object.erase(member) : std::next(member);
        }
        return true;
    }

    bool wrongType(Kind expected, const std::string& where) {
        return m_source.fail("gltf.schema", where,
                             std::string(kDescriptions[static_cast<std::size_t>(expected)]) +
                                 " is expected here");
    }

    Source& m_source;
};

} // namespace

bool checkSchema(Source& source, Json& root) { return Checker(source).checkObject(root, kFileSchema, ""); }

} // namespace franken::gltf
