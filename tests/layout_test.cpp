// SPDX-License-Identifier: MIT
// The arrows between the project's parts, read off their includes: a part includes what the table below
// allows it and nothing else, and public headers include no third party's but those that they are made for.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace franken::test {
namespace {

namespace fs = std::filesystem;

using Strings = std::vector<std::string>;

const fs::path kRoot = FRANKEN_SOURCE_DIR;

struct Part {
    std::string folder;
    Strings uses;       ///< Other parts.
    Strings thirdParty; ///< Beginnings of the third-party headers that its public headers may include.
};

/// The longest matching folder is a file's part.
const std::vector<Part> kParts = {
    {"lib/base", {}, {}},
    {"generator", {"lib/base"}, {}},
    {"generator/command_line", {"lib/base"}, {"CLI/"}},
    {"generator/cli", {"lib/base", "generator", "generator/command_line"}, {}},
    {"lib/programs", {"lib/base", "generator"}, {"GLES2/gl2.h"}},
    {"lib/assets", {"lib/base", "generator"}, {"glm/"}},
    {"lib/assets/src/gltf",
     {"lib/base", "generator", "lib/assets", "lib/assets/src/mesh", "lib/assets/src/image",
      "lib/assets/src/animation"},
     {}},
    {"lib/assets/src/sky", {"lib/base", "generator", "lib/assets", "lib/assets/src/image"}, {}},
    {"lib/assets/src/image", {"lib/base", "lib/assets"}, {}},
    {"lib/assets/src/mesh", {"lib/base", "lib/assets"}, {}},
    {"lib/assets/src/font", {"lib/base", "lib/assets"}, {}},
    {"lib/assets/src/animation", {"lib/base", "lib/assets"}, {}},
    {"lib/renderer", {"lib/base", "generator", "lib/programs", "lib/assets"}, {"glm/"}},
    {"platform", {"lib/base"}, {}},
    {"examples",
     {"lib/base", "generator", "generator/command_line", "lib/programs", "lib/assets", "lib/renderer",
      "platform", "examples/price"},
     {}},
    {"examples/price", {"lib/base", "generator", "generator/cli", "lib/assets", "lib/renderer"}, {}},
    // The playground shows what `frankenshader` prints.
    {"examples/web", {"lib/base", "generator", "generator/cli", "lib/assets", "lib/renderer"}, {}},
};

/// Of generator, lib/assets sees the plain structs of lights and materials alone.
const Strings kOfGeneratorForAssets = {"franken/generator/ambient.h", "franken/generator/light.h",
                                       "franken/generator/pack.h", "franken/generator/texture_role.h"};

bool contains(const Strings& list, const std::string& entry) {
    return std::find(list.begin(), list.end(), entry) != list.end();
}

const Part* partOf(const std::string& file) {
    const Part* best = nullptr;
    for (const Part& part : kParts)
        if (file.starts_with(part.folder + "/") &&
            (best == nullptr || part.folder.size() > best->folder.size()))
            best = &part;
    return best;
}

bool isSource(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

/// Paths from the root, with slashes.
Strings sources(const Strings& tops = {"lib", "generator", "platform", "examples"}) {
    Strings files;
    for (const std::string& top : tops)
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / top))
            if (entry.is_regular_file() && isSource(entry.path()))
                files.push_back(fs::relative(entry.path(), kRoot).generic_string());
    return files;
}

/// The file that an include means, from the root; empty for a header of a third party or of the system.
std::string resolve(const std::string& include, const std::string& from) {
    const Part& part = *partOf(from);
    Strings places = {fs::path(from).parent_path().generic_string(), part.folder, part.folder + "/src",
                      "lib/assets/src", "examples"};
    places.insert(places.end(), part.uses.begin(), part.uses.end());
    if (include.starts_with("franken/"))
        for (const Part& other : kParts)
            for (const char* headers : {"/include", "/internal"})
                places.push_back(other.folder + headers);
    for (const std::string& place : places)
        if (fs::exists(kRoot / place / include))
            return (fs::path(place) / include).lexically_normal().generic_string();
    return "";
}

struct Include {
    std::string name;
    bool quoted;
};

std::vector<Include> includesOf(const std::string& file) {
    const std::string directive = "#include ";
    std::vector<Include> includes;
    std::ifstream in(kRoot / file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(directive)) {
            const std::string rest = line.substr(directive.size());
            const std::size_t end = rest.find_first_of("\">", 1);
            includes.push_back({rest.substr(1, end - 1), rest.front() == '"'});
        }
    return includes;
}

TEST(Layout, EachPartIncludesOnlyWhatItMayUse) {
    int arrows = 0;
    for (const std::string& file : sources()) {
        const Part& from = *partOf(file);
        for (const auto& [name, quoted] : includesOf(file)) {
            const std::string target = quoted ? resolve(name, file) : "";
            if (target.empty())
                continue;
            const Part& to = *partOf(target);
            if (to.folder == from.folder)
                continue;
            ++arrows;
            EXPECT_TRUE(contains(from.uses, to.folder))
                << file << " includes " << name << ": " << from.folder << " may not use " << to.folder;
            if (from.folder.starts_with("lib/assets") && to.folder == "generator") {
                EXPECT_TRUE(contains(kOfGeneratorForAssets, name)) << file << " includes " << name;
            }
        }
    }
    EXPECT_GT(arrows, 100) << "the includes were not found";
}

TEST(Layout, EachIncludeInQuotesIsAFileOfOurs) {
    for (const std::string& file : sources()) {
        if (file.starts_with("examples/embed"))
            continue; // They are built against an installed package.
        for (const auto& [name, quoted] : includesOf(file)) {
            if (quoted) {
                EXPECT_FALSE(resolve(name, file).empty()) << file << " includes " << name;
            }
        }
    }
}

TEST(Layout, PublicHeadersIncludeTheStandardLibraryAndWhatTheirPartIsMadeFor) {
    int headers = 0;
    for (const std::string& file : sources()) {
        if (file.find("/include/franken/") == std::string::npos)
            continue;
        ++headers;
        const Part& part = *partOf(file);
        for (const auto& [name, quoted] : includesOf(file)) {
            const auto allows = [&](const std::string& beginning) { return name.starts_with(beginning); };
            const bool ofTheStandardLibrary = name.find_first_of("./") == std::string::npos;
            EXPECT_TRUE(quoted || ofTheStandardLibrary ||
                        std::any_of(part.thirdParty.begin(), part.thirdParty.end(), allows))
                << file << " includes " << name;
        }
    }
    EXPECT_GT(headers, 40);
}

/// Names of the standard library that other headers of it bring along in one release and not in the next.
const std::map<std::string, Strings> kNamesOfHeaders = {
    {"algorithm",
     {"all_of",      "any_of",      "clamp",   "copy",       "copy_n",      "count",  "count_if",
      "equal",       "fill",        "find",    "find_if",    "lower_bound", "max",    "max_element",
      "min",         "min_element", "none_of", "remove_if",  "reverse",     "rotate", "sort",
      "stable_sort", "transform",   "unique",  "upper_bound"}},
    {"cmath",
     {"atan2", "ceil", "cos", "floor", "hypot", "isfinite", "lround", "pow", "round", "sin", "sqrt"}},
    {"cstdlib", {"abort", "exit", "getenv", "strtod", "strtol", "system"}},
    {"cstring", {"memcmp", "memcpy", "memset", "strcmp", "strlen"}},
};

/// The names behind "std::" in a file's code.
std::set<std::string> standardNames(const std::string& file) {
    const std::string space = "std::";
    std::set<std::string> names;
    std::ifstream in(kRoot / file);
    for (std::string line; std::getline(in, line);) {
        line.erase(std::min(line.find("//"), line.size()));
        for (std::size_t at = line.find(space); at != std::string::npos; at = line.find(space, at)) {
            at += space.size();
            const auto end = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789", at);
            names.insert(line.substr(at, end - at));
        }
    }
    return names;
}

TEST(Layout, EachFileIncludesTheStandardHeadersThatOthersOnlyHappenToBring) {
    for (const std::string& file : sources({"lib", "generator", "platform", "examples", "tests"})) {
        const std::set<std::string> used = standardNames(file);
        const std::vector<Include> includes = includesOf(file);
        for (const auto& [header, names] : kNamesOfHeaders)
            for (const std::string& name : names)
                if (used.contains(name)) {
                    EXPECT_TRUE(std::any_of(includes.begin(), includes.end(),
                                            [&](const Include& include) { return include.name == header; }))
                        << file << " uses std::" << name << " and does not include <" << header << ">";
                }
    }
}

} // namespace
} // namespace franken::test
