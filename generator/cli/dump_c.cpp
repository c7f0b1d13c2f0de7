// SPDX-License-Identifier: MIT
#include "dump_c.h"

#include "franken/generator/pack.h"

namespace franken::cli {
namespace {

constexpr char kBegin[] = R"(/* Written by frankenshader dump --format c. Do not edit. */
#ifndef FRANKENSHADER_PROGRAMS_H
#define FRANKENSHADER_PROGRAMS_H

typedef struct { const char *name, *type; int location; } FrankenAttribute;
/* block: whose numbers they are, "frame", "lights", "material" or "object"; offset: where a value begins in
   that block of franken/generator/pack.h, in floats; -1 where it is in none. */
typedef struct { const char *name, *type, *block; int count, offset; } FrankenUniform;
typedef struct { const char *name, *type; int unit; } FrankenSampler;
/* The tables end with a row whose name is 0. */
typedef struct {
    const char *name, *key, *vertex, *fragment;
    const FrankenAttribute *attributes;
    const FrankenUniform *uniforms;
    const FrankenSampler *samplers;
} FrankenProgram;
)";

std::string identifier(std::string_view name) {
    std::string text(name);
    for (char& c : text)
        if (const bool word = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); !word)
            c = '_';
    return text;
}

std::string inQuotes(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += '\\';
        result += c;
    }
    return result + "\"";
}

// A literal a line, which compilers join.
std::string literal(const std::string& text) {
    std::string result;
    for (const std::string_view line : linesOf(text)) {
        const std::string literalLine = inQuotes(line);
        result += "\n    " + literalLine.substr(0, literalLine.size() - 1) + "\\n\"";
    }
    return result.empty() ? "\"\"" : result;
}

std::string table(const char* type, const std::string& name, const std::string& rows, const char* last) {
    return std::string("static const ") + type + " " + name + "[] = {\n" + rows + "    " + last + "};\n";
}

std::string attributes(const Interface& interface, const std::string& name) {
    std::string rows;
    for (const Attribute& each : interface.attributes)
        rows += "    {" + inQuotes(each.name) + ", " + inQuotes(toGlsl(each.type)) + ", " +
                std::to_string(each.location) + "},\n";
    return table("FrankenAttribute", name, rows, "{0, 0, 0}");
}

std::string uniforms(const Interface& interface, const std::string& name) {
    std::string rows;
    for (const Uniform& each : interface.uniforms)
        rows += "    {" + inQuotes(each.name) + ", " + inQuotes(toGlsl(each.type)) + ", " +
                inQuotes(toText(each.block)) + ", " + std::to_string(each.count) + ", " +
                std::to_string(fieldOffset(each)) + "},\n";
    return table("FrankenUniform", name, rows, "{0, 0, 0, 0, 0}");
}

std::string samplers(const Interface& interface, const std::string& name) {
    std::string rows;
    for (const Sampler& each : interface.samplers)
        rows += "    {" + inQuotes(each.name) + ", " + inQuotes(toGlsl(each.type)) + ", " +
                std::to_string(each.unit) + "},\n";
    return table("FrankenSampler", name, rows, "{0, 0, 0}");
}

} // namespace

std::string DumpC::begin() const { return kBegin; }

std::string DumpC::program(const Program& program) {
    const std::string prefix = "franken_" + identifier(program.name);
    const Composed& composed = program.composed;
    m_table += "    {" + inQuotes(program.name) + ", " + inQuotes(toHex(toKey(program.permutation))) + ", " +
               prefix + "_vertex, " + prefix + "_fragment, " + prefix + "_attributes, " + prefix +
               "_uniforms, " + prefix + "_samplers},\n";
    ++m_count;
    return "\n/* " + program.name + " */\nstatic const char " + prefix +
           "_vertex[] =" + literal(composed.vertex.text) + ";\nstatic const char " + prefix +
           "_fragment[] =" + literal(composed.fragment.text) + ";\n" +
           attributes(composed.interface, prefix + "_attributes") +
           uniforms(composed.interface, prefix + "_uniforms") +
           samplers(composed.interface, prefix + "_samplers");
}

std::string DumpC::end() const {
    return "\nenum { franken_program_count = " + std::to_string(m_count) + " };\n" +
           table("FrankenProgram", "franken_programs", m_table, "{0, 0, 0, 0, 0, 0, 0}") + "\n#endif\n";
}

} // namespace franken::cli
